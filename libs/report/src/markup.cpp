// SPDX-License-Identifier: Apache-2.0
#include "markup.hpp"

#include "skein/foundation/contract.hpp"
#include "skein/foundation/markup.hpp"

namespace skein::report {

void Markup::start(std::string_view element, Attributes attributes) {
  out_ += '<';
  out_ += element;
  for (const Attribute& a : attributes) {
    out_ += ' ';
    out_ += a.name;
    out_ += "=\"";
    out_ += escaped_markup(a.value);
    out_ += '"';
  }
}

Markup& Markup::open(std::string_view element, Attributes attributes) {
  start(element, attributes);
  out_ += '>';
  open_.emplace_back(element);
  return *this;
}

Markup& Markup::close() {
  SKEIN_EXPECTS(!open_.empty());
  out_ += "</" + open_.back() + ">";
  open_.pop_back();
  return *this;
}

Markup& Markup::leaf(std::string_view element, Attributes attributes) {
  start(element, attributes);
  out_ += "/>";
  return *this;
}

Markup& Markup::element(std::string_view element, Attributes attributes, std::string_view content) {
  return open(element, attributes).text(content).close();
}

Markup& Markup::text(std::string_view content) {
  out_ += escaped_markup(content);
  return *this;
}

Markup& Markup::raw(std::string_view piece) {
  out_ += piece;
  return *this;
}

Markup& Markup::line_break() {
  out_ += '\n';
  return *this;
}

std::string Markup::take() {
  SKEIN_EXPECTS(open_.empty());
  return std::move(out_);
}

}  // namespace skein::report
