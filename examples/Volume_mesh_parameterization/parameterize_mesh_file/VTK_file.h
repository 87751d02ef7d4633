// Meshes in VTK's legacy format (*.vtk), of all its versions, as text or binary.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_VTK_FILE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_VTK_FILE_H

#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <sstream>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;

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

inline void read_by_VTK(const std::string& filename, VMP::Tetrahedron_soup_3& soup)
{
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

  // as VTK's newer format, which the library reads
  grid.GetFieldData()->Initialize();
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(&grid);
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  writer->WriteToOutputStringOn();
  writer->Write();
  std::istringstream is(writer->GetOutputString());
  VMP::IO::read_VTU(is, soup);
  if(!messages.warning.empty())
    soup.notes.insert(soup.notes.begin(), "VTK says: " + messages.warning);
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_VTK_FILE_H
