// SPDX-License-Identifier: Apache-2.0
#include "skein/xml/element.hpp"

#include <expat.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>

namespace skein::xml {

namespace {

/// Makes the tree from the events of the library's parser.
class TreeBuilder {
 public:
  TreeBuilder(XML_Parser parser, Limits limits) : parser_(parser), limits_(limits) {
    XML_SetUserData(parser, this);
    XML_SetElementHandler(
        parser,
        [](void* self, const char* name, const char** attributes) {
          static_cast<TreeBuilder*>(self)->start(name, attributes);
        },
        [](void* self, const char*) { static_cast<TreeBuilder*>(self)->end(); });
    XML_SetCharacterDataHandler(parser, [](void* self, const char* text, int length) {
      static_cast<TreeBuilder*>(self)->open_.back()->text.append(text,
                                                                 static_cast<std::size_t>(length));
    });
    XML_SetStartDoctypeDeclHandler(
        parser, [](void* self, const char*, const char*, const char*, int) {
          static_cast<TreeBuilder*>(self)->stop("a document type declaration", "none");
        });
  }

  Element take() { return std::move(root_); }

  /// Why it was stopped, or why this is no XML.
  Diagnostic problem() const {
    if (stopped_) return *stopped_;
    return here(std::string("not XML: ") + XML_ErrorString(XML_GetErrorCode(parser_)), "");
  }

 private:
  Diagnostic here(std::string why, std::string expected) const {
    return {"",
            static_cast<int>(XML_GetCurrentLineNumber(parser_)),
            static_cast<int>(XML_GetCurrentColumnNumber(parser_)) + 1,
            "",
            std::move(why),
            std::move(expected),
            ""};
  }

  void start(const char* name, const char** attributes) {
    if (stopped_) return;
    if (open_.size() == limits_.deepest)
      return stop("nested more than " + std::to_string(limits_.deepest) + " deep", "");
    if (++count_ > limits_.most_elements)
      return stop("more than " + std::to_string(limits_.most_elements) + " elements", "");
    Element element;
    element.name = name;
    for (; *attributes != nullptr; attributes += 2)
      element.attributes.emplace_back(attributes[0], attributes[1]);
    element.line = static_cast<int>(XML_GetCurrentLineNumber(parser_));
    element.column = static_cast<int>(XML_GetCurrentColumnNumber(parser_)) + 1;
    // The addresses stay valid: a parent gets no child before the open one is closed.
    Element& kept = open_.empty() ? root_ : open_.back()->children.emplace_back();
    kept = std::move(element);
    open_.push_back(&kept);
  }

  void end() {
    if (!stopped_) open_.pop_back();
  }

  void stop(std::string why, std::string expected) {
    if (stopped_) return;
    stopped_ = here(std::move(why), std::move(expected));
    XML_StopParser(parser_, XML_FALSE);
  }

  XML_Parser parser_;
  Limits limits_;
  Element root_;
  std::vector<Element*> open_;
  std::size_t count_ = 0;
  std::optional<Diagnostic> stopped_;
};

tl::unexpected<Diagnostic> problem_of(Diagnostic problem, const std::string& file) {
  problem.file = file;
  return tl::make_unexpected(std::move(problem));
}

}  // namespace

const std::string* Element::attribute(std::string_view attribute_name) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const auto& one) { return one.first == attribute_name; });
  return found == attributes.end() ? nullptr : &found->second;
}

Result<Element, Diagnostic> parse(std::string_view text, const std::string& file, Encoding encoding,
                                  Limits limits) {
  if (text.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    return problem_of({"", 0, 0, "", "larger than 2 GB", "", ""}, file);
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate(encoding == Encoding::kUtf8 ? "UTF-8" : nullptr), &XML_ParserFree);
  if (!parser) return problem_of({"", 0, 0, "", "no memory for reading XML", "", ""}, file);
  TreeBuilder builder(parser.get(), limits);
  const XML_Status status =
      XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
  if (status != XML_STATUS_OK) return problem_of(builder.problem(), file);
  return builder.take();
}

}  // namespace skein::xml
