// SPDX-License-Identifier: Apache-2.0
#include "xml_document.hpp"

#include <expat.h>

#include <algorithm>
#include <memory>
#include <type_traits>

namespace skein::temporal {

namespace {

constexpr std::size_t kDeepest = 16;
constexpr std::size_t kMostElements = 1'000'000;

/// Makes the tree from the events of the library's parser.
class TreeBuilder {
 public:
  TreeBuilder(XML_Parser parser, Problems& problems) : parser_(parser), problems_(problems) {
    XML_SetUserData(parser, this);
    XML_SetElementHandler(
        parser,
        [](void* self, const char* name, const char** attributes) {
          static_cast<TreeBuilder*>(self)->start(name, attributes);
        },
        [](void* self, const char*) { static_cast<TreeBuilder*>(self)->open_.pop_back(); });
    XML_SetCharacterDataHandler(parser, [](void* self, const char* text, int length) {
      static_cast<TreeBuilder*>(self)->open_.back()->text.append(text,
                                                                 static_cast<std::size_t>(length));
    });
    XML_SetStartDoctypeDeclHandler(
        parser, [](void* self, const char*, const char*, const char*, int) {
          static_cast<TreeBuilder*>(self)->stop("a document type declaration", "none");
        });
  }

  bool stopped() const { return stopped_; }
  Place place() const {
    return {static_cast<int>(XML_GetCurrentLineNumber(parser_)),
            static_cast<int>(XML_GetCurrentColumnNumber(parser_)) + 1, ""};
  }
  XmlElement take() { return std::move(root_); }

 private:
  void start(const char* name, const char** attributes) {
    if (stopped_) return;
    if (open_.size() == kDeepest) {
      return stop("nested more than " + std::to_string(kDeepest) + " deep", "");
    }
    if (++count_ > kMostElements) {
      return stop("more than " + std::to_string(kMostElements) + " elements", "");
    }
    XmlElement element;
    element.name = name;
    for (; *attributes != nullptr; attributes += 2) {
      element.attributes.emplace_back(attributes[0], attributes[1]);
    }
    const Place here = place();
    element.line = here.line;
    element.column = here.column;
    // The addresses stay valid: a parent gets no child before the open one is closed.
    XmlElement& kept = open_.empty() ? root_ : open_.back()->children.emplace_back();
    kept = std::move(element);
    open_.push_back(&kept);
  }

  void stop(std::string why, std::string expected) {
    if (stopped_) return;
    stopped_ = true;
    problems_.add(place(), std::move(why), std::move(expected));
    XML_StopParser(parser_, XML_FALSE);
  }

  XML_Parser parser_;
  Problems& problems_;
  XmlElement root_;
  std::vector<XmlElement*> open_;
  std::size_t count_ = 0;
  bool stopped_ = false;
};

}  // namespace

const std::string* XmlElement::attribute(std::string_view attribute_name) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const auto& one) { return one.first == attribute_name; });
  return found == attributes.end() ? nullptr : &found->second;
}

std::optional<XmlElement> parse_xml(std::string_view text, Problems& problems,
                                    XmlEncoding encoding) {
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate(encoding == XmlEncoding::kUtf8 ? "UTF-8" : nullptr), &XML_ParserFree);
  if (!parser) {
    problems.add({}, "no memory for reading XML");
    return std::nullopt;
  }
  TreeBuilder builder(parser.get(), problems);
  // The length fits: read_network() bounds it.
  const XML_Status status =
      XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
  if (status == XML_STATUS_OK) return builder.take();
  if (!builder.stopped()) {
    const std::string why = XML_ErrorString(XML_GetErrorCode(parser.get()));
    problems.add(builder.place(), "not XML: " + why);
  }
  return std::nullopt;
}

}  // namespace skein::temporal
