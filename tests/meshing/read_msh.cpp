#include "meshing/read_msh.hpp"

#include <fstream>
#include <map>
#include <stdexcept>

namespace meshing::testing {

namespace {

template <std::size_t N>
std::array<int, N> read_nodes(std::istream& in) {
  std::array<int, N> nodes{};
  for (int& node : nodes) {
    in >> node;
    --node;
  }
  return nodes;
}

} // namespace

LinearMesh read_msh(const std::filesystem::path& file) {
  std::ifstream in(file);
  LinearMesh mesh;
  std::map<int, int> surface_of; // physical tag
  int fluid = 0;
  std::string section;
  while (in >> section) {
    std::size_t count = 0;
    if (section == "$MeshFormat") {
      std::string format;
      in >> std::ws;
      std::getline(in, format);
      if (format != "2.2 0 8")
        throw std::runtime_error("format " + format);
    } else if (section == "$PhysicalNames") {
      for (in >> count; count > 0; --count) {
        int dimension = 0, tag = 0;
        std::string name;
        in >> dimension >> tag >> name;
        name = name.substr(1, name.size() - 2);
        if (dimension == 3 && name == "fluid")
          fluid = tag;
        else if (dimension == 2) {
          surface_of[tag] = static_cast<int>(mesh.surfaces.size());
          mesh.surfaces.push_back(name);
        } else
          throw std::runtime_error("name " + name);
      }
    } else if (section == "$Nodes") {
      for (in >> count; count > 0; --count) {
        std::size_t number = 0;
        pfv::Vec3 node;
        in >> number >> node.x() >> node.y() >> node.z();
        mesh.nodes.push_back(node);
        if (number != mesh.nodes.size())
          throw std::runtime_error("node " + std::to_string(number));
      }
    } else if (section == "$Elements") {
      for (in >> count; count > 0; --count) {
        int number = 0, type = 0, tags = 0, physical = 0, elementary = 0;
        in >> number >> type >> tags >> physical >> elementary;
        if (tags == 2 && type == 2)
          mesh.triangles.push_back({read_nodes<3>(in), surface_of.at(physical)});
        else if (tags == 2 && type == 4 && physical == fluid)
          mesh.tetrahedra.push_back(read_nodes<4>(in));
        else
          throw std::runtime_error("element " + std::to_string(number));
      }
    } else
      throw std::runtime_error("section " + section);
    std::string end;
    if (!(in >> end) || end != "$End" + section.substr(1))
      throw std::runtime_error("end of " + section);
  }
  return mesh;
}

} // namespace meshing::testing
