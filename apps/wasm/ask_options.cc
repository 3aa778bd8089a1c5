#include "apps/wasm/ask_options.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "tautline/scene/document.h"
#include "tautline/scene/field_reader.h"
#include "tautline/scene/json_document.h"

namespace tautline::wasm {
namespace {

/// Reads the members of one object, each into its place where it is there.
class OptionsReader {
 public:
  explicit OptionsReader(const Document& options) : options_(options), reader_("options") {}

  void Flag(const char* key, bool& to) {
    const Document* value = options_.Find(key);
    if (value == nullptr) return;
    if (!value->is(Document::Kind::kBool)) {
      return reader_.Fail(value->position, std::string(key) + " must be true or false, not " + Describe(*value));
    }
    to = value->boolean;
  }

  /// A whole number of 1 or more.
  template <class Count>
  void AtLeastOne(const char* key, Count& to) {
    const Document* value = options_.Find(key);
    if (value == nullptr) return;
    const double number = reader_.ReadNumber(*value, key);
    if (reader_.ok() && (number < 1 || number != std::floor(number))) {
      reader_.Fail(value->position, std::string(key) + " must be a whole number of 1 or more");
    }
    if (reader_.ok()) to = static_cast<std::int64_t>(number);
  }

  /// Metres, 0 or more.
  template <class Length>
  void NonNegative(const char* key, Length& to) {
    if (const Document* value = options_.Find(key)) to = reader_.ReadNonNegative(*value, key);
  }

  /// A number larger than 0.
  template <class Number>
  void Positive(const char* key, Number& to) {
    if (const Document* value = options_.Find(key)) to = reader_.ReadPositive(*value, key);
  }

  /// One number larger than 0, or a list of such.
  void Positives(const char* key, std::vector<double>& to) {
    const Document* value = options_.Find(key);
    if (value == nullptr) return;
    if (!value->is(Document::Kind::kList)) return to.push_back(reader_.ReadPositive(*value, key));
    for (const Document& item : value->items) to.push_back(reader_.ReadPositive(item, key));
  }

  void APoint(const char* key, std::optional<Point>& to) {
    if (const Document* value = options_.Find(key)) to = reader_.ReadPoint(*value, key);
  }

  void Word(std::optional<std::string>& to) {
    const Document* value = options_.Find("word");
    if (value == nullptr) return;
    if (options_.Find("max_length") != nullptr || options_.Find("count") != nullptr) {
      return reader_.Fail(value->position, "word excludes max_length and count: one word has one class");
    }
    // The empty text is the empty word, which ReadText would refuse.
    const bool is_empty = value->is(Document::Kind::kString) && value->text.empty();
    to = is_empty ? "" : reader_.ReadText(*value, "word");
  }

  void Mode(FleetMode& to) {
    const Document* value = options_.Find("mode");
    if (value == nullptr) return;
    const std::string text = reader_.ReadText(*value, "mode");
    const std::optional<FleetMode> mode = FleetModeNamed(text);
    if (mode) to = *mode;
    if (!reader_.ok() || mode) return;
    reader_.Fail(value->position, "mode is " + Quoted(text) +
                                      ": it must be straight-concurrent, straight-sequential, bent-concurrent or "
                                      "bent-sequential");
  }

  void Resolution(std::optional<double>& to) {
    if (const Document* value = options_.Find("resolution")) to = reader_.ReadPositive(*value, "resolution");
  }

  void Connectivity(std::optional<int>& to) {
    const Document* value = options_.Find("connectivity");
    if (value == nullptr) return;
    const double number = reader_.ReadNumber(*value, "connectivity");
    if (reader_.ok() && number != 4 && number != 8) reader_.Fail(value->position, "connectivity must be 4 or 8");
    if (reader_.ok()) to = static_cast<int>(number);
  }

  /// The names of robots.
  void Order(std::vector<std::string>& to) {
    const Document* value = options_.Find("order");
    if (value == nullptr) return;
    if (options_.Find("mode") != nullptr) {
      return reader_.Fail(value->position, "order excludes mode: robots drive one after the other, without a plan");
    }
    if (!value->is(Document::Kind::kList) || value->items.empty()) {
      return reader_.Fail(value->position, "order must be a list of names, not " + Describe(*value));
    }
    for (const Document& item : value->items) to.push_back(reader_.ReadText(item, "a name in order"));
  }

  void Unknown(bool& is_free) {
    const Document* value = options_.Find("unknown");
    if (value == nullptr) return;
    const std::string text = reader_.ReadText(*value, "unknown");
    if (reader_.ok() && text != "blocked" && text != "free") {
      reader_.Fail(value->position, "unknown is " + Quoted(text) + ": it must be blocked or free");
    }
    is_free = text == "free";
  }

  FieldReader& reader() { return reader_; }

 private:
  const Document& options_;
  FieldReader reader_;
};

void ReadPlan(OptionsReader& options, PlanQuestion& question) {
  options.Flag("verify", question.verify);
  options.Flag("all", question.options.all);
  options.Flag("crossing_free", question.options.crossing_free);
  options.AtLeastOne("count", question.options.max_all);
  options.AtLeastOne("budget", question.options.budget);
}

void ReadClasses(OptionsReader& options, ClassesQuestion& question) {
  options.Flag("verify", question.verify);
  options.APoint("from", question.from);
  options.APoint("to", question.to);
  options.NonNegative("max_length", question.options.max_length);
  options.AtLeastOne("count", question.options.max_count);
  options.Word(question.word);
  options.AtLeastOne("budget", question.options.budget);
}

void ReadReach(OptionsReader& options, ReachQuestion& question) {
  options.Flag("verify", question.verify);
  options.Flag("sheets", question.options.sheets);
  options.APoint("at", question.options.at);
  options.AtLeastOne("budget", question.options.budget);
}

void ReadPose(OptionsReader& options, PoseQuestion& question) {
  options.Flag("verify", question.verify);
  options.APoint("at", question.at);
}

void ReadMove(OptionsReader& options, MoveQuestion& question) {
  options.Flag("verify", question.verify);
  options.APoint("from", question.from);
  options.APoint("to", question.to);
  options.Positive("speed", question.options.speed);
  options.Positive("acceleration", question.options.acceleration);
  options.Positives("winch_limit", question.options.winch_limits);
  options.Positive("dt", question.dt);
}

void ReadTour(OptionsReader& options, TourQuestion& question) {
  options.Flag("verify", question.verify);
  options.APoint("from", question.from);
  options.APoint("to", question.to);
  options.Flag("round", question.round);
  options.AtLeastOne("rounds", question.options.rounds_per_task);
}

void ReadBest(OptionsReader& options, BestQuestion& question) {
  options.Flag("verify", question.verify);
  options.NonNegative("max_boundary", question.max_boundary);
  options.NonNegative("count_longer", question.longer_to);
  options.AtLeastOne("count", question.count);
  options.AtLeastOne("budget", question.budget);
}

void ReadLayouts(OptionsReader& options, LayoutsQuestion& question) {
  options.Flag("verify", question.verify);
  options.NonNegative("max_length", question.options.max_length);
  options.NonNegative("max_total", question.options.max_total);
  options.AtLeastOne("count", question.options.max_count);
  options.Flag("count_all", question.options.count_all);
  options.AtLeastOne("budget", question.options.budget);
}

void ReadFleetPlan(OptionsReader& options, AskOptions& asked) {
  options.Flag("animate", asked.animate);
  options.Mode(asked.fleet_plan.options.mode);
  options.Flag("speeds", asked.fleet_plan.options.speeds);
  options.NonNegative("gap", asked.fleet_plan.options.gap);
  options.AtLeastOne("budget", asked.fleet_plan.budget);
}

void ReadSimulate(OptionsReader& options, AskOptions& asked) {
  options.Flag("animate", asked.animate);
  options.Mode(asked.simulate.mode);
  options.Order(asked.simulate.order);
}

void ReadManifold(OptionsReader& options, ManifoldQuestion& question) {
  options.Resolution(question.cells.resolution_m);
  options.Connectivity(question.connectivity);
  options.Flag("literal", question.literal);
  options.Flag("sheets", question.sheets);
  options.Flag("field", question.field);
  options.Flag("deadlocks", question.deadlocks);
  options.AtLeastOne("max_nodes", question.max_vertices);
  options.AtLeastOne("max_bytes", question.max_bytes);
}

/// A command with the options that it knows besides those of all, and how they are read.
struct CommandOptions {
  const char* name;
  std::vector<std::string_view> keys;
  void (*read)(OptionsReader& options, AskOptions& asked);
};

std::vector<CommandOptions> AllCommands() {
  return {
      {"plan",
       {"all", "crossing_free", "count", "budget"},
       [](OptionsReader& o, AskOptions& asked) { ReadPlan(o, asked.plan); }},
      {"reach", {"sheets", "at", "budget"}, [](OptionsReader& o, AskOptions& asked) { ReadReach(o, asked.reach); }},
      {"classes",
       {"from", "to", "max_length", "count", "word", "budget"},
       [](OptionsReader& o, AskOptions& asked) { ReadClasses(o, asked.classes); }},
      {"taut", {}, [](OptionsReader& o, AskOptions& asked) { o.Flag("verify", asked.taut.verify); }},
      {"show", {}, [](OptionsReader&, AskOptions&) {}},
      {"workspace boundary", {}, [](OptionsReader& o, AskOptions& asked) { o.Flag("verify", asked.boundary.verify); }},
      {"workspace best",
       {"max_boundary", "count_longer", "count", "budget"},
       [](OptionsReader& o, AskOptions& asked) { ReadBest(o, asked.best); }},
      {"workspace pose", {"at"}, [](OptionsReader& o, AskOptions& asked) { ReadPose(o, asked.pose); }},
      {"workspace move",
       {"from", "to", "speed", "acceleration", "winch_limit", "dt"},
       [](OptionsReader& o, AskOptions& asked) { ReadMove(o, asked.move); }},
      {"workspace tour",
       {"from", "to", "round", "rounds"},
       [](OptionsReader& o, AskOptions& asked) { ReadTour(o, asked.tour); }},
      {"fleet check", {}, [](OptionsReader&, AskOptions&) {}},
      {"fleet layouts",
       {"max_length", "max_total", "count", "count_all", "budget"},
       [](OptionsReader& o, AskOptions& asked) { ReadLayouts(o, asked.layouts); }},
      {"fleet plan", {"mode", "speeds", "gap", "budget", "animate"}, ReadFleetPlan},
      {"fleet simulate", {"mode", "order", "animate"}, ReadSimulate},
      {"manifold",
       {"resolution", "connectivity", "literal", "sheets", "field", "deadlocks", "max_nodes", "max_bytes"},
       [](OptionsReader& o, AskOptions& asked) { ReadManifold(o, asked.manifold); }},
  };
}

/// "plan, reach and show".
std::string NamesOf(const std::vector<CommandOptions>& commands) {
  std::string names = commands[0].name;
  for (std::size_t i = 1; i + 1 < commands.size(); ++i) names += std::string(", ") + commands[i].name;
  return names + " and " + commands.back().name;
}

}  // namespace

Expected<AskOptions> ReadAskOptions(const std::string& name, const std::string& text) {
  const std::vector<CommandOptions> commands = AllCommands();
  const auto command =
      std::find_if(commands.begin(), commands.end(), [&name](const CommandOptions& c) { return name == c.name; });
  if (command == commands.end()) {
    return InvalidInput("there is no command " + Quoted(name) + "; there are " + NamesOf(commands));
  }
  AskOptions asked;
  if (text.empty()) return asked;
  const auto document = ParseJson(text, "options");
  if (!document) return tl::unexpected(document.error());
  OptionsReader options(*document);
  FieldReader& reader = options.reader();
  if (reader.IsMap(*document, "options")) {
    std::vector<std::string_view> keys = {"svg", "verify", "unknown", "simplify"};
    keys.insert(keys.end(), command->keys.begin(), command->keys.end());
    reader.KnownKeys(*document, "the options of " + name, keys);
    options.Flag("svg", asked.svg);
    options.Unknown(asked.scene.unknown_free);
    options.NonNegative("simplify", asked.scene.simplify);
    command->read(options, asked);
  }
  if (!reader.ok()) return tl::unexpected(reader.error());
  return asked;
}

}  // namespace tautline::wasm
