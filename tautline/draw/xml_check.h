// A tiny checker of well-formed XML, for tests.
#ifndef TAUTLINE_DRAW_XML_CHECK_H_
#define TAUTLINE_DRAW_XML_CHECK_H_

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tautline {

/// Reads the subset of XML that SvgWriter writes: no comments, no CDATA, attributes in double
/// quotes.
class XmlCheck {
 public:
  explicit XmlCheck(std::string_view text) : text_(text) { Run(); }

  /// "" when the text is well formed, else what is wrong and where.
  const std::string& error() const { return error_; }

  /// The values of all `class` attributes.
  const std::set<std::string>& classes() const { return classes_; }

  std::size_t elements() const { return elements_; }

 private:
  void Run() {
    if (text_.starts_with("<?xml")) at_ = text_.find("?>") + 2;
    while (error_.empty() && at_ < text_.size()) {
      if (text_[at_] == '<') {
        Tag();
      } else {
        Content('<');
      }
    }
    if (error_.empty() && (!open_.empty() || elements_ == 0)) Fail("element not closed");
  }

  void Fail(const std::string& what) {
    error_ = what + " at byte " + std::to_string(at_) + ": " + std::string(text_.substr(at_, 40));
  }

  /// Text up to `end`; every & starts a known reference.
  std::string_view Content(char end) {
    const std::size_t begin = at_;
    for (; at_ < text_.size() && text_[at_] != end; ++at_) {
      if (text_[at_] == '<') return Fail("raw <"), "";
      if (text_[at_] != '&') continue;
      const std::string_view name = text_.substr(at_, text_.find(';', at_) + 1 - at_);
      static constexpr std::string_view kKnown[] = {"&lt;", "&gt;", "&amp;", "&quot;", "&#39;"};
      bool known = false;
      for (const std::string_view reference : kKnown) known = known || name == reference;
      if (!known) return Fail("unknown reference"), "";
    }
    return text_.substr(begin, at_ - begin);
  }

  void Tag() {
    const bool closing = text_[at_ + 1] == '/';
    at_ += closing ? 2 : 1;
    const std::size_t end = text_.find_first_of(" />", at_);
    const std::string name(text_.substr(at_, end - at_));
    at_ = end;
    if (closing) {
      if (open_.empty() || open_.back() != name) return Fail("closes " + name);
      open_.pop_back();
      ++at_;
      return;
    }
    ++elements_;
    if (open_.empty() && elements_ > 1) return Fail("second root");
    Attributes();
    if (!error_.empty()) return;
    if (text_[at_] == '/') {
      at_ += 2;
    } else {
      open_.push_back(name);
      ++at_;
    }
  }

  void Attributes() {
    std::set<std::string> seen;
    while (error_.empty() && text_[at_] == ' ') {
      const std::size_t equals = text_.find('=', ++at_);
      const std::string name(text_.substr(at_, equals - at_));
      if (text_[equals + 1] != '"' || !seen.insert(name).second) return Fail("attribute " + name);
      at_ = equals + 2;
      const std::string value(Content('"'));
      if (name == "class") classes_.insert(value);
      ++at_;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t elements_ = 0;
  std::vector<std::string> open_;
  std::set<std::string> classes_;
  std::string error_;
};

}  // namespace tautline

#endif  // TAUTLINE_DRAW_XML_CHECK_H_
