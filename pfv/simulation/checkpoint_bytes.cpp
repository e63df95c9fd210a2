#include "pfv/problem/error.hpp"
#include "pfv/simulation/checkpoint.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace pfv {
namespace {

using Json = nlohmann::json;

/// Every field by name, for writing and reading alike. What is not a vector is flat: numbers without gaps.
template <class Archive, class Of>
void visit_fields(Archive& field, Of& of) {
  field("box", of.grains.packing.box);
  field("spheres", of.grains.packing.spheres);
  field("periodic", of.grains.periodic);
  field("velocity", of.grains.velocity);
  field("mass", of.grains.mass);
  field("number", of.grains.number);
  field("wall velocity", of.grains.wall_velocity);
  field("grown", of.grains.grown);
  field("first radius", of.grains.first_radius);
  if (field.names("cohesion", of.cohesion))
    field("strength", *of.cohesion);
  field("pair start", of.contacts.pairs.start);
  field("pair other", of.contacts.pairs.other);
  field("pair shear", of.contacts.pairs.shear);
  field("pair bond", of.contacts.pairs.bond);
  for (const Face face : all_faces)
    field(fmt::format("at {}", face_names[index(face)]), of.contacts.at_walls.of_face[index(face)]);
  field("loads", of.loads);
  field("on wall", of.on_wall);
  field("energy", of.energy);
  field("broken bonds", of.broken_bonds);
  field("steps", of.steps);
  field("time", of.time);
  if (field.names("fluid", of.fluid)) {
    field("pressure", of.fluid->above_level);
    field("level", of.fluid->level);
    field("fluid counts", of.fluid->counts);
  }
}

class Writer {
public:
  template <class T>
  void operator()(const std::string& name, const std::vector<T>& values) {
    write(name, values.data(), values.size() * sizeof(T));
  }
  template <class T>
  void operator()(const std::string& name, const T& value) {
    static_assert(std::is_trivially_destructible_v<T>);
    write(name, &value, sizeof(T));
  }
  /// In columns, as there are gaps in a contact.
  void operator()(const std::string& name, const std::vector<CandidateWalls::Contact>& contacts) {
    std::vector<int> grain;
    std::vector<Vec3> shear;
    std::vector<Bond> bond;
    for (const auto& contact : contacts) {
      grain.push_back(contact.grain);
      shear.push_back(contact.shear);
      bond.push_back(contact.bond);
    }
    (*this)(name + " grain", grain);
    (*this)(name + " shear", shear);
    (*this)(name + " bond", bond);
  }
  template <class T>
  bool names(const char* name, const std::optional<T>& part) {
    fields[name] = part.has_value();
    return part.has_value();
  }

  Json fields;

private:
  void write(const std::string& name, const void* from, std::size_t size) {
    const auto* first = static_cast<const std::uint8_t*>(from);
    fields[name] = Json::binary(std::vector<std::uint8_t>(first, first + size));
  }
};

class Reader {
public:
  explicit Reader(Json from) : fields_(std::move(from)) {}

  template <class T>
  void operator()(const std::string& name, std::vector<T>& values) {
    const auto& bytes = field(name);
    if (bytes.size() % sizeof(T) != 0)
      throw InputError(fmt::format("\"{}\" has {} bytes, not a multiple of {}", name, bytes.size(), sizeof(T)));
    values.resize(bytes.size() / sizeof(T));
    if (!bytes.empty())
      std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
  }
  template <class T>
  void operator()(const std::string& name, T& value) {
    const auto& bytes = field(name);
    if (bytes.size() != sizeof(T))
      throw InputError(fmt::format("\"{}\" has {} bytes, not {}", name, bytes.size(), sizeof(T)));
    std::memcpy(static_cast<void*>(&value), bytes.data(), bytes.size());
  }
  void operator()(const std::string& name, std::vector<CandidateWalls::Contact>& contacts) {
    std::vector<int> grain;
    std::vector<Vec3> shear;
    std::vector<Bond> bond;
    (*this)(name + " grain", grain);
    (*this)(name + " shear", shear);
    (*this)(name + " bond", bond);
    require(shear.size() == grain.size() && bond.size() == grain.size(), name);
    for (std::size_t k = 0; k < grain.size(); ++k)
      contacts.push_back({grain[k], shear[k], bond[k]});
  }
  template <class T>
  bool names(const char* name, std::optional<T>& part) {
    if (fields_.at(name).get<bool>())
      part.emplace();
    return part.has_value();
  }
  static void require(bool fits, const std::string& name) {
    if (!fits)
      throw InputError(fmt::format("\"{}\" does not fit the rest", name));
  }

private:
  const Json::binary_t& field(const std::string& name) const { return fields_.at(name).get_binary(); }

  Json fields_;
};

void require_consistent(const Checkpoint& of) {
  const auto grains = of.grains.packing.spheres.size();
  const auto is_grain = [&](int number) { return number >= 0 && static_cast<std::size_t>(number) < grains; };
  const auto& pairs = of.contacts.pairs;
  Reader::require(of.grains.velocity.size() == grains, "velocity");
  Reader::require(of.grains.mass.size() == grains && of.loads.size() == grains, "mass");
  Reader::require(of.grains.first_radius.empty() || of.grains.first_radius.size() == grains, "first radius");
  Reader::require(of.grains.number.size() == grains && std::ranges::all_of(of.grains.number, is_grain), "number");
  Reader::require(pairs.start.size() == grains + 1 && std::ranges::is_sorted(pairs.start) && pairs.start[0] == 0 &&
                      pairs.start.back() == static_cast<int>(pairs.other.size()),
                  "pair start");
  Reader::require(std::ranges::all_of(pairs.other, is_grain) && pairs.shear.size() == pairs.other.size() &&
                      pairs.bond.size() == pairs.other.size(),
                  "pair other");
  for (const auto& contacts : of.contacts.at_walls.of_face)
    Reader::require(std::ranges::all_of(contacts, is_grain, &CandidateWalls::Contact::grain), "grains at walls");
}

} // namespace

std::string to_bytes(const Checkpoint& checkpoint) {
  Writer writer;
  visit_fields(writer, checkpoint);
  std::string bytes;
  Json::to_cbor(writer.fields, bytes);
  return bytes;
}

Checkpoint from_bytes(std::string_view bytes) {
  Checkpoint checkpoint;
  try {
    Reader reader(Json::from_cbor(bytes));
    visit_fields(reader, checkpoint);
  } catch (const Json::exception& error) {
    throw InputError(error.what());
  }
  require_consistent(checkpoint);
  return checkpoint;
}

} // namespace pfv
