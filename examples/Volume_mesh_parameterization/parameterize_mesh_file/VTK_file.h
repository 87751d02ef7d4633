// Meshes in VTK's legacy format (*.vtk), of all its versions, as text or binary.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_VTK_FILE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_VTK_FILE_H

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/VTK_cells.h>

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

inline std::vector<CGAL::Volume_mesh_parameterization::Data_array_3> data_of_VTK(vtkFieldData& data)
{
  std::vector<CGAL::Volume_mesh_parameterization::Data_array_3> result;
  for(int a = 0; a < data.GetNumberOfArrays(); ++a)
  {
    vtkDataArray* const array = data.GetArray(a);
    if(array == nullptr || array->GetName() == nullptr) // text, for instance
      continue;
    const bool has_integers = array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
    result.push_back({ array->GetName(), static_cast<std::size_t>(array->GetNumberOfComponents()), has_integers, {} });
    for(vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      for(int k = 0; k < array->GetNumberOfComponents(); ++k)
        result.back().values.push_back(array->GetComponent(i, k));
  }
  return result;
}

// The first error and the first warning of VTK.
struct VTK_messages
{
  std::string error, warning;
};

// Keeps the sentence of a message, which begins with a line on VTK's code. Of numbers that it cannot read, VTK only warns.
inline void keep_message(vtkObject*, const unsigned long event, void* const messages, void* const message)
{
  std::string sentence = static_cast<const char*>(message);
  sentence.erase(0, sentence.find('\n') + 1);
  if(const std::size_t object = sentence.find("): "); object != sentence.npos)
    sentence.erase(0, object + 3);
  std::replace(sentence.begin(), sentence.end(), '\n', ' ');
  sentence.erase((std::min)(sentence.find("(0x"), sentence.find_last_not_of(' ') + 1)); // an address
  auto& [error, warning] = *static_cast<VTK_messages*>(messages);
  std::string& first = event == vtkCommand::ErrorEvent || sentence.find("Error reading") == 0 ? error : warning;
  if(first.empty())
    first = sentence;
}

inline CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 read_by_VTK(const std::string& filename)
{
  namespace VMP = CGAL::Volume_mesh_parameterization;
  static VTK_messages messages;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&messages);
  observer->SetCallback(keep_message);
  for(const unsigned long event : { vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
    vtkOutputWindow::GetInstance()->AddObserver(event, observer);
  vtkNew<vtkUnstructuredGridReader> reader;
  reader->SetFileName(filename.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllFieldsOn();
  if(!reader->IsFileUnstructuredGrid())
    throw VMP::Input_error("this is not a VTK file of the type UNSTRUCTURED_GRID");
  reader->Update();
  vtkUnstructuredGrid& grid = *reader->GetOutput();
  if(reader->GetErrorCode() != 0 || !messages.error.empty() || grid.GetNumberOfPoints() == 0)
    throw VMP::Input_error("VTK cannot read the file. " + messages.error);

  VMP::Tetrahedron_soup_3 soup;
  if(!messages.warning.empty())
    soup.notes.push_back("VTK says: " + messages.warning);
  for(vtkIdType v = 0; v < grid.GetNumberOfPoints(); ++v)
  {
    const double* const p = grid.GetPoint(v);
    soup.points.push_back({ VMP::internal::checked_coordinate(p[0]), VMP::internal::checked_coordinate(p[1]),
                            VMP::internal::checked_coordinate(p[2]) });
  }
  soup.point_data = data_of_VTK(*grid.GetPointData());
  VMP::internal::VTK_cells_reader cells(soup, data_of_VTK(*grid.GetCellData()));
  vtkNew<vtkIdList> vertices;
  for(vtkIdType c = 0; c < grid.GetNumberOfCells(); ++c)
  {
    grid.GetCellPoints(c, vertices);
    cells.add(static_cast<std::size_t>(c), grid.GetCellType(c), vertices->begin(),
              static_cast<std::size_t>(vertices->GetNumberOfIds()));
  }
  cells.finish();
  return soup;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_VTK_FILE_H
