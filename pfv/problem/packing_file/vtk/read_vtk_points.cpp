#include "pfv/problem/packing_file/vtk/read_vtk_points.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/packing_file/vtk/apart.hpp"
#include "pfv/problem/packing_file/vtk/vtk_points_bytes.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>
#include <vtkAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace pfv {
namespace {

/// Keeps the first thing that VTK complains of, on which it would go on.
class FirstComplaint : public vtkOutputWindow {
public:
  static FirstComplaint* New() { return new FirstComplaint; }
  void DisplayText(const char* text) override {
    if (text_.empty())
      text_ = text;
  }
  bool made() const { return !text_.empty(); }
  /// VTK leads it with a line of where in its sources, and often "vtkReader (0x...): ".
  std::string in_one_line() const {
    std::string_view text = text_;
    text.remove_prefix(std::min(text.find('\n') + 1, text.size()));
    text = text.substr(0, text.find('\n'));
    const auto address = text.find("): ");
    return std::string(address == std::string_view::npos ? text : text.substr(address + 3));
  }

private:
  std::string text_;
};

std::vector<VtkArray> arrays_of(vtkFieldData* data) {
  std::vector<VtkArray> arrays;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data->GetArray(i);
    if (!array || !array->GetName()) // texts are no numbers
      continue;
    VtkArray read{array->GetName(), array->GetNumberOfComponents(), {}};
    read.values.reserve(static_cast<std::size_t>(array->GetNumberOfValues()));
    for (vtkIdType tuple = 0; tuple < array->GetNumberOfTuples(); ++tuple)
      for (int component = 0; component < read.components; ++component)
        read.values.push_back(array->GetComponent(tuple, component));
    arrays.push_back(std::move(read));
  }
  return arrays;
}

VtkPoints points_of(vtkPointSet* set) {
  VtkPoints read;
  if (vtkPoints* points = set->GetPoints())
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) {
      double at[3];
      points->GetPoint(i, at);
      read.coordinates.insert(read.coordinates.end(), at, at + 3);
    }
  read.of_points = arrays_of(set->GetPointData());
  read.of_file = arrays_of(set->GetFieldData());
  return read;
}

VtkPoints points_read_by(vtkAlgorithm* reader, const std::string& file) {
  vtkNew<FirstComplaint> complaint;
  vtkOutputWindow::SetInstance(complaint);
  reader->Update();
  if (complaint->made())
    throw InputError(fmt::format("{}: not sound VTK: {}", file, complaint->in_one_line()));
  auto* set = vtkPointSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (!set)
    throw InputError(fmt::format("{}: VTK without points of their own; PolyData or UnstructuredGrid is needed", file));
  return points_of(set);
}

template <typename Reader>
VtkPoints read_with(const std::string& file, const std::string& contents) {
  vtkNew<Reader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(contents);
  return points_read_by(reader, file);
}

/// What the element <VTKFile type="..."> says, or nothing.
std::string type_of(const std::string& contents) {
  const auto element = contents.find("<VTKFile");
  if (element == std::string::npos)
    return {};
  const std::string tag = contents.substr(element, contents.find('>', element) - element);
  const auto type = tag.find("type=\"");
  return type == std::string::npos ? std::string{} : tag.substr(type + 6, tag.find('"', type + 6) - type - 6);
}

VtkPoints read(const std::string& file, const std::string& contents) {
  if (contents.starts_with("# vtk DataFile"))
    return read_with<vtkGenericDataObjectReader>(file, contents);
  const std::string type = type_of(contents);
  if (type == "PolyData")
    return read_with<vtkXMLPolyDataReader>(file, contents);
  if (type == "UnstructuredGrid")
    return read_with<vtkXMLUnstructuredGridReader>(file, contents);
  throw InputError(fmt::format("{}: VTK type \"{}\" must be PolyData (.vtp) or UnstructuredGrid (.vtu)", file, type));
}

} // namespace

// VTK's readers do not check what they read: a damaged file may take the process down, and must not take ours.
VtkPoints read_vtk_points(const std::string& file, const std::string& contents) {
  const Allowance allowance{.memory = (std::size_t{1} << 30) + 64 * contents.size(),
                            .cpu_seconds = 5 + contents.size() / 1'000'000};
  const auto bytes = answer_apart([&] { return bytes_of(read(file, contents)); }, allowance);
  if (!bytes)
    throw InputError(fmt::format("{}: not sound VTK: VTK's reader fails on it", file));
  return vtk_points_in(*bytes);
}

} // namespace pfv
