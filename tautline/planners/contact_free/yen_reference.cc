#include "tautline/planners/contact_free/yen_reference.h"

#include <algorithm>
#include <map>
#include <utility>

#include "tautline/planners/contact_free/line_of_sight.h"
#include "tautline/planners/contact_free/path_lattice.h"
#include "tautline/planners/contact_free/yen_paths.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

/// The dictionary of Algorithm 1.
using Signatures = std::map<Word, TautPath>;

/// Lines 13 to 23: a path is shortened and kept where its signature is new, or where, not yet shortened, it is shorter
/// than the one kept.
void Offer(const TautSpace& space, const Polyline& points, Signatures& signatures) {
  const Word word = space.rays().WordOf(points);
  const auto kept = signatures.find(word);
  if (kept != signatures.end() && Length(points) >= kept->second.length) return;
  TautPath path{ShortenByLineOfSight(space, points), 0, word};
  path.length = Length(path.points);
  signatures.insert_or_assign(word, std::move(path));
}

/// Leads all paths on from where the socket is.
void Prepend(const TautSpace& space, const Socket& socket, std::vector<TautPath>& paths) {
  if (socket.stub_length == 0) return;
  for (TautPath& path : paths) {
    path.points.insert(path.points.begin(), socket.base);
    path = space.MakePath(std::move(path.points));
  }
}

/// Algorithm 2, once both dictionaries are there.
class DictionarySearch {
 public:
  DictionarySearch(const ReferenceTask& task, const LaidTether& laid, const TautSpace& space)
      : space_(space), limit_(task.cable_length_m * (1 + kLengthTolerance)), laid_word_(laid.Pull(space).word) {}

  ReferenceSelection Run(std::vector<TautPath> from_robot, const std::vector<TautPath>& from_base) {
    for (const TautPath& path : from_base) by_word_.emplace(path.word, &path);
    for (TautPath& path : from_robot) {
      ReferenceCandidate candidate{.path = std::move(path)};
      candidate.tether_word = laid_word_ * candidate.path.word;
      if (const auto known = by_word_.find(candidate.tether_word); known != by_word_.end()) {
        candidate.tether = *known->second;
        candidate.fits = candidate.tether->length <= limit_;
      }
      result_.candidates.push_back(std::move(candidate));
    }
    Choose();
    return std::move(result_);
  }

 private:
  void Choose() {
    for (const ReferenceCandidate& candidate : result_.candidates) {
      if (!candidate.fits) continue;
      result_.reference = ReferencePath{.path = candidate.path.points,
                                        .length_m = candidate.path.length,
                                        .word = candidate.path.word,
                                        .tether_word = candidate.tether_word,
                                        .tether_length_m = candidate.tether->length};
      return;
    }
    const TautPath* shortest = nullptr;
    for (const ReferenceCandidate& candidate : result_.candidates) {
      if (candidate.tether && (shortest == nullptr || candidate.tether->length < shortest->length)) {
        shortest = &*candidate.tether;
      }
    }
    result_.outcome = ReferenceOutcome::kTetherTooShort;
    if (shortest != nullptr) {
      result_.shortest_tether = *shortest;
      result_.explanation = ExplainTetherTooShort(space_, *shortest, limit_ / (1 + kLengthTolerance));
    } else {
      result_.explanation = "no path found has a tether among those found; choose another goal or look at more paths";
    }
  }

  const TautSpace& space_;
  double limit_;
  Word laid_word_;
  std::map<Word, const TautPath*> by_word_;
  ReferenceSelection result_;
};

ReferenceSelection Refuse(ReferenceOutcome outcome, std::string explanation) {
  ReferenceSelection result;
  result.outcome = outcome;
  result.explanation = std::move(explanation);
  return result;
}

}  // namespace

Expected<std::vector<TautPath>> EnumerateSignatures(const TautSpace& space, Point from, Point to,
                                                    const YenOptions& options) {
  const auto lattice = BuildPathLattice(space, from, to, options.step_m);
  if (!lattice) return tl::unexpected(lattice.error());
  const PathGraph& graph = lattice->graph;
  if (lattice->from == lattice->to) return std::vector<TautPath>{space.MakePath({graph.point(lattice->from)})};
  Signatures signatures;
  const auto offer_all = [&](PathNodeId start, PathNodeId end, bool backwards) {
    const YenQuery query{.from = start, .to = end, .count = options.count, .keep_going = options.keep_going};
    for (SimplePath& path : YenPaths(graph, query)) {
      if (backwards) std::reverse(path.nodes.begin(), path.nodes.end());
      Offer(space, graph.PointsOf(path.nodes), signatures);
    }
  };
  offer_all(lattice->from, lattice->to, false);
  offer_all(lattice->to, lattice->from, true);
  std::vector<TautPath> paths;
  for (auto& [word, path] : signatures) paths.push_back(std::move(path));
  std::stable_sort(paths.begin(), paths.end(),
                   [](const TautPath& a, const TautPath& b) { return a.length < b.length; });
  return paths;
}

Expected<ReferenceSelection> SelectReferenceByYen(const TautGround& ground, const ReferenceTask& task,
                                                  const YenOptions& options) {
  const TautSpace& space = ground.space();
  const auto goal = space.Locate(task.goal);
  if (!goal) {
    return Refuse(ReferenceOutcome::kGoalBlocked,
                  "the goal " + ToText(task.goal) + " lies " + BlockedText(space.free_space()));
  }
  const FollowedTether followed = FollowTether(ground, task.laid);
  if (!followed.laid) return Refuse(followed.outcome, followed.explanation);
  const LaidTether& laid = *followed.laid;
  auto from_robot = EnumerateSignatures(space, laid.robot.exit.point, goal->point, options);
  if (!from_robot) return tl::unexpected(from_robot.error());
  auto from_base = EnumerateSignatures(space, laid.base.exit.point, goal->point, options);
  if (!from_base) return tl::unexpected(from_base.error());
  if (from_robot->empty()) {
    return Refuse(ReferenceOutcome::kGoalUnreachable, "the lattice has no way to the goal " + ToText(task.goal) +
                                                          "; choose another goal or a smaller step");
  }
  Prepend(space, laid.robot, *from_robot);
  Prepend(space, laid.base, *from_base);
  return DictionarySearch(task, laid, space).Run(*std::move(from_robot), *from_base);
}

}  // namespace tautline
