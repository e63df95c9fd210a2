#include "studies/runner/row.hpp"

#include "pfv/problem/error.hpp"

#include <fmt/format.h>

#include <charconv>
#include <concepts>
#include <functional>

namespace studies {

namespace {

std::string written(const std::string& value) {
  return value;
}
std::string written(Status value) {
  return std::string(name(value));
}
template <class Number>
requires std::integral<Number> || std::floating_point<Number> std::string written(Number value) {
  return fmt::format("{}", value);
}
std::string written(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "";
}
std::string written(const std::vector<pfv::Stage>& stages) {
  std::string text;
  for (const pfv::Stage& stage : stages)
    text += fmt::format("{}{}={}", text.empty() ? "" : ";", stage.name, stage.cpu_seconds);
  return text;
}

void read(const std::string& text, std::string& value) {
  value = text;
}
void read(const std::string& text, Status& value) {
  value = status_from(text);
}
template <class Number>
requires std::integral<Number> || std::floating_point<Number>
void read(const std::string& text, Number& value) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end)
    throw pfv::InputError(fmt::format("'{}' is not a number", text));
}
void read(const std::string& text, std::optional<double>& value) {
  if (!text.empty())
    read(text, value.emplace());
}
void read(const std::string& text, std::vector<pfv::Stage>& stages) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    const std::size_t equals = text.rfind('=', end - 1);
    if (equals == std::string::npos || equals < begin)
      throw pfv::InputError(fmt::format("'{}' is not a list name=seconds;...", text));
    pfv::Stage stage{text.substr(begin, equals - begin)};
    read(text.substr(equals + 1, end - equals - 1), stage.cpu_seconds);
    stages.push_back(stage);
    begin = end + 1;
  }
}

struct Column {
  std::string name;
  std::function<std::string(const Row&)> write;
  std::function<void(const std::string&, Row&)> read;
};

template <class T>
Column column(std::string name, T Row::*member) {
  return {std::move(name), [member](const Row& row) { return written(row.*member); },
          [member](const std::string& text, Row& row) { read(text, row.*member); }};
}

const std::vector<Column>& columns() {
  static const std::vector<Column> list{
      column("key", &Row::key),
      column("study", &Row::study),
      column("case", &Row::case_id),
      column("case_digest", &Row::case_digest),
      column("spheres", &Row::spheres),
      column("method", &Row::method),
      column("mesh_size", &Row::mesh_size),
      column("convergence_order", &Row::convergence_order),
      column("status", &Row::status),
      column("message", &Row::message),
      column("permeability_m2", &Row::permeability),
      column("porosity", &Row::porosity),
      column("unknowns", &Row::unknowns),
      column("stages_cpu_s", &Row::stages),
      column("process_cpu_s", &Row::process_cpu_seconds),
      column("wall_s", &Row::wall_seconds),
      column("peak_memory_bytes", &Row::peak_memory_bytes),
      column("memory_bytes", &Row::memory_bytes),
      column("repeats", &Row::repeats),
      column("estimated_cpu_s", &Row::estimated_cpu_seconds),
      column("estimated_memory_bytes", &Row::estimated_memory_bytes),
      column("method_version", &Row::method_version),
      column("answer_sources", &Row::answer_sources),
      column("commit", &Row::commit),
      column("compiler", &Row::compiler),
      column("flags", &Row::flags),
      column("machine", &Row::machine),
      column("started_utc", &Row::started),
  };
  return list;
}

} // namespace

const CsvRecord& row_columns() {
  static const CsvRecord names = [] {
    CsvRecord record;
    for (const Column& one : columns())
      record.push_back(one.name);
    return record;
  }();
  return names;
}

CsvRecord to_record(const Row& row) {
  CsvRecord record;
  for (const Column& one : columns())
    record.push_back(one.write(row));
  return record;
}

Row row_from(const CsvRecord& record) {
  if (record.size() != columns().size())
    throw pfv::InputError(fmt::format("{} columns instead of {}", record.size(), columns().size()));
  Row row;
  for (std::size_t i = 0; i < record.size(); ++i) {
    try {
      columns()[i].read(record[i], row);
    } catch (const pfv::InputError& error) {
      throw pfv::InputError(fmt::format("column {}: {}", columns()[i].name, error.what()));
    }
  }
  return row;
}

} // namespace studies
