// render_scene SCENE.json PICTURE.png: draws a scene with VTK. Needs an X server, which xvfb-run gives it; a program of
// its own, so that no other one loads what draws.
#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "studies/render/scene.hpp"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCamera.h>
#include <vtkClipClosedSurface.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkOutlineSource.h>
#include <vtkPNGWriter.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTexture.h>
#include <vtkWindowToImageFilter.h>

#include <cstdio>
#include <fmt/format.h>

namespace studies {

namespace {

constexpr int pixels = 900;

vtkNew<vtkActor> surface(vtkAlgorithmOutput* what) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(what);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  return actor;
}

/// The six planes of a box; what they keep is inside.
vtkNew<vtkPlaneCollection> planes_of(const pfv::Box& box) {
  vtkNew<vtkPlaneCollection> planes;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      vtkNew<vtkPlane> plane;
      pfv::Vec3 at = box.lower, normal = pfv::Vec3::Zero();
      at[axis] = upper ? box.upper[axis] : box.lower[axis];
      normal[axis] = upper ? -1 : 1;
      plane->SetOrigin(at.data());
      plane->SetNormal(normal.data());
      planes->AddItem(plane);
    }
  return planes;
}

bool meets(const pfv::Sphere& sphere, const pfv::Box& box) {
  const pfv::Vec3 nearest = sphere.centre.cwiseMax(box.lower).cwiseMin(box.upper);
  return (nearest - sphere.centre).norm() < sphere.radius;
}

bool holds(const pfv::Box& box, const pfv::Sphere& sphere) {
  return ((sphere.centre - box.lower).array() >= sphere.radius).all() &&
         ((box.upper - sphere.centre).array() >= sphere.radius).all();
}

/// The part of each sphere that is in the piece, closed where it is cut.
void add_spheres(const RenderScene& scene, const pfv::Box& piece, vtkRenderer* renderer) {
  vtkNew<vtkAppendPolyData> all;
  const auto planes = planes_of(piece);
  for (const pfv::Sphere& sphere : scene.spheres) {
    if (!meets(sphere, piece))
      continue;
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(sphere.centre.data());
    ball->SetRadius(sphere.radius);
    ball->SetThetaResolution(64);
    ball->SetPhiResolution(48);
    vtkNew<vtkClipClosedSurface> part;
    part->SetInputConnection(ball->GetOutputPort());
    part->SetClippingPlanes(planes);
    if (holds(piece, sphere))
      all->AddInputConnection(ball->GetOutputPort());
    else {
      part->Update();
      if (part->GetOutput()->GetNumberOfCells() > 0)
        all->AddInputConnection(part->GetOutputPort());
    }
  }
  if (all->GetNumberOfInputConnections(0) == 0)
    return;
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(all->GetOutputPort());
  normals->SetFeatureAngle(30);
  const auto actor = surface(normals->GetOutputPort());
  actor->GetProperty()->SetColor(0.82, 0.82, 0.80);
  actor->GetProperty()->SetAmbient(0.25);
  actor->GetProperty()->SetSpecular(0.15);
  actor->GetProperty()->SetSpecularPower(30);
  renderer->AddActor(actor);
}

void add_panel(const Panel& panel, vtkRenderer* renderer) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(panel.columns, panel.rows, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (std::size_t i = 0; i < panel.colours.size(); ++i)
    for (int part = 0; part < 3; ++part)
      image->GetPointData()->GetScalars()->SetComponent(static_cast<vtkIdType>(i), part, panel.colours[i][part]);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOff();
  vtkNew<vtkPlaneSource> plane;
  const pfv::Vec3 right = panel.corner + panel.across, top = panel.corner + panel.up;
  plane->SetOrigin(panel.corner.x(), panel.corner.y(), panel.corner.z());
  plane->SetPoint1(right.x(), right.y(), right.z());
  plane->SetPoint2(top.x(), top.y(), top.z());
  const auto actor = surface(plane->GetOutputPort());
  actor->SetTexture(texture);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

void add_frame(const pfv::Box& box, vtkRenderer* renderer) {
  vtkNew<vtkOutlineSource> outline;
  outline->SetBounds(box.lower.x(), box.upper.x(), box.lower.y(), box.upper.y(), box.lower.z(), box.upper.z());
  const auto actor = surface(outline->GetOutputPort());
  actor->GetProperty()->SetColor(0.5, 0.5, 0.5);
  actor->GetProperty()->SetLineWidth(2);
  renderer->AddActor(actor);
}

void draw(const RenderScene& scene, const char* file) {
  vtkNew<vtkRenderer> renderer;
  for (const pfv::Box& piece : scene.pieces)
    add_spheres(scene, piece, renderer);
  for (const Panel& panel : scene.panels)
    add_panel(panel, renderer);
  add_frame(scene.box, renderer);
  vtkNew<vtkLightKit> lights;
  lights->AddLightsToRenderer(renderer);
  const pfv::Vec3 middle = (scene.box.lower + scene.box.upper) / 2;
  const pfv::Vec3 eye = middle + scene.towards_eye.normalized() * 3 * scene.box.size().norm();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(middle.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(scene.upwards.data());
  camera->SetViewAngle(20);
  renderer->ResetCamera();
  camera->Zoom(1.02);
  renderer->SetBackgroundAlpha(0); // the page shows through
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetAlphaBitPlanes(1);
  window->SetMultiSamples(8);
  window->SetSize(pixels, pixels);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->SetInputBufferTypeToRGBA();
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> png;
  png->SetFileName(file);
  png->SetInputConnection(image->GetOutputPort());
  png->Write();
  if (png->GetErrorCode() != 0)
    throw pfv::InputError(fmt::format("\"{}\" cannot be written", file));
}

} // namespace

} // namespace studies

int main(int count, char** arguments) {
  try {
    if (count != 3)
      throw pfv::InputError("usage: render_scene SCENE.json PICTURE.png");
    studies::draw(studies::render_scene_from(pfv::read_text(arguments[1])), arguments[2]);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "render_scene: {}\n", error.what());
    return 2;
  }
}
