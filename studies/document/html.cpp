#include "studies/document/html.hpp"

#include "studies/document/inline_html.hpp"
#include "studies/document/page_parts.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <set>
#include <span>

namespace studies {

namespace {

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    const std::size_t there = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < there ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= there ? digits[bits >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

/// Writes blocks one after the other, and remembers the headings to link to.
class Writer {
public:
  void write(std::span<const Block> blocks) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const bool in_group = is_picture(blocks[i]);
      if (in_group && (i == 0 || !is_picture(blocks[i - 1])))
        body_ += "<div class=\"figures\">\n";
      std::visit([this](const auto& is) { write(is); }, blocks[i].is);
      if (in_group && (i + 1 == blocks.size() || !is_picture(blocks[i + 1])))
        body_ += "</div>\n";
    }
  }
  const std::string& body() const { return body_; }
  const std::string& contents() const { return contents_; }

private:
  static bool is_picture(const Block& block) {
    return std::holds_alternative<Figure>(block.is) || std::holds_alternative<Plot>(block.is);
  }

  /// A name for the address bar, no two alike.
  std::string id_for(const Heading& heading) {
    std::string id;
    for (const char c : heading.text) {
      const auto byte = static_cast<unsigned char>(c);
      if (std::isalnum(byte) != 0)
        id += static_cast<char>(std::tolower(byte));
      else if (!id.empty() && id.back() != '-')
        id += '-';
    }
    while (id.ends_with('-'))
      id.pop_back();
    std::string unique = id;
    for (int n = 2; !ids_.insert(unique).second; ++n)
      unique = fmt::format("{}-{}", id, n);
    if (heading.level == 2)
      contents_ += fmt::format("<a href=\"#{}\">{}</a>\n", unique, inline_html(heading.text));
    return unique;
  }

  void write(const Heading& heading) {
    body_ += fmt::format("<h{0} id=\"{1}\">{2}</h{0}>\n", heading.level, id_for(heading), inline_html(heading.text));
  }

  void write(const Paragraph& paragraph) {
    const char* kind = paragraph.text.starts_with(outcome_lead) ? " class=\"outcome\"" : "";
    body_ += fmt::format("<p{}>{}</p>\n", kind, inline_html(paragraph.text));
  }

  void write(const List& list) {
    body_ += "<ul>\n";
    for (const std::string& item : list.items)
      body_ += fmt::format("<li>{}</li>\n", inline_html(item));
    body_ += "</ul>\n";
  }

  void write(const Code& code) { body_ += fmt::format("<pre><code>{}</code></pre>\n", escaped(code.text)); }

  void write(const Table& table) {
    body_ += "<div class=\"table\"><div class=\"scroll\"><table>\n<thead><tr>";
    for (const Table::Column& column : table.columns)
      body_ +=
          fmt::format("<th scope=\"col\"{}>{}</th>", column.numbers ? " class=\"n\"" : "", inline_html(column.title));
    body_ += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
      body_ += "<tr>";
      for (std::size_t i = 0; i < row.size(); ++i)
        body_ += fmt::format("<td{}>{}</td>", kind_of(table.columns[i], row[i]), inline_html(row[i]));
      body_ += "</tr>\n";
    }
    body_ += "</tbody>\n</table></div></div>\n";
  }

  static const char* kind_of(const Table::Column& column, const std::string& cell) {
    if (column.numbers)
      return " class=\"n\"";
    // The target of a link is not seen.
    const auto middle = cell.find("]("), end = cell.find(')', middle);
    const std::size_t unseen = middle == cell.npos || end == cell.npos ? 0 : end - middle;
    return cell.size() - unseen > 40 ? " class=\"long\"" : "";
  }

  void write(const Figure& figure) {
    body_ += "<figure>\n";
    if (figure.picture.starts_with("<svg"))
      body_ += figure.picture;
    else if (!figure.picture.empty())
      body_ += fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", escaped(figure.caption),
                           base64(figure.picture));
    else
      body_ += fmt::format("<p class=\"missing\">No picture: {}.</p>", escaped(figure.why_not));
    body_ += fmt::format("\n<figcaption>{}</figcaption>\n</figure>\n", inline_html(figure.caption));
  }

  void write(const Plot& plot) { write(Figure{plot.caption, "", "", "it was not drawn"}); }

  void write(const Details& details) {
    body_ += fmt::format("<details id=\"{0}\">\n<summary><h{1}>{2}</h{1}></summary>\n", id_for(details.heading),
                         details.heading.level, inline_html(details.heading.text));
    write(std::span(details.blocks));
    body_ += "</details>\n";
  }

  std::string body_, contents_;
  std::set<std::string> ids_;
};

} // namespace

std::string to_html(const Document& document) {
  Writer writer;
  writer.write(document.blocks);
  std::string title = escaped(document.title);
  return fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                     "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                     "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n"
                     "<header><nav>\n{}</nav></header>\n<main>\n<h1>{}</h1>\n{}</main>\n<script>\n{}</script>\n"
                     "</body>\n</html>\n",
                     title, page_style, writer.contents(), inline_html(document.title), writer.body(), page_script);
}

} // namespace studies
