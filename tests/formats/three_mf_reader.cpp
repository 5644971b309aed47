#include "tests/formats/three_mf_reader.h"

#include <Model/COM/NMR_DLLInterfaces.h>
#include <catch2/catch.hpp>
#include <cstdio>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace dini::support {

namespace {

void need(LIB3MFRESULT result) {
  if (result != 0) FAIL("lib3mf says " << std::hex << result);
}

/// A text that lib3mf writes into a buffer.
template <class Read>
std::string text_of(const Read& read) {
  std::string text(4096, '\0');
  ULONG length = 0;
  need(read(text.data(), static_cast<ULONG>(text.size()), &length));
  return text.c_str();
}

std::string material_of(NMR::PLib3MFModel* model, NMR::PLib3MFPropertyHandler* properties) {
  DWORD group = 0, index = 0;
  need(NMR::lib3mf_propertyhandler_getbasematerial(properties, 0, &group, &index));
  NMR::PLib3MFModelBaseMaterial* materials = nullptr;
  need(NMR::lib3mf_model_getbasematerialbyid(model, group, &materials));
  std::array<BYTE, 4> color{};
  need(NMR::lib3mf_basematerial_getdisplaycolor(materials, index, &color[0], &color[1], &color[2], &color[3]));
  std::string name = text_of([&](char* text, ULONG size, ULONG* length) {
    return NMR::lib3mf_basematerial_getnameutf8(materials, index, text, size, length);
  });
  NMR::lib3mf_release(materials);
  char digits[16];
  std::snprintf(digits, sizeof(digits), " #%02X%02X%02X%02X", color[0], color[1], color[2], color[3]);
  return name + digits;
}

void read_looks(NMR::PLib3MFModel* model, NMR::PLib3MFPropertyHandler* properties, ThreeMfObject& object) {
  NMR::eModelPropertyType type{};
  need(NMR::lib3mf_propertyhandler_getpropertytype(properties, 0, &type));
  if (type == NMR::MODELPROPERTYTYPE_BASEMATERIALS) object.material = material_of(model, properties);
  if (type != NMR::MODELPROPERTYTYPE_COLOR) return;
  for (DWORD i = 0; i < object.triangles.size(); ++i) {
    NMR::MODELMESH_TRIANGLECOLOR_SRGB colors{};
    need(NMR::lib3mf_propertyhandler_getcolor(properties, i, &colors));
    auto& corners = object.colors.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& color = colors.m_Colors[k];
      corners[k] = {color.m_Red, color.m_Green, color.m_Blue, color.m_Alpha};
    }
  }
}

ThreeMfObject read_object(NMR::PLib3MFModel* model, NMR::PLib3MFModelMeshObject* mesh) {
  ThreeMfObject object;
  object.name = text_of(
      [&](char* text, ULONG size, ULONG* length) { return NMR::lib3mf_object_getnameutf8(mesh, text, size, length); });
  DWORD type = 0, vertices = 0, triangles = 0;
  BOOL manifold = 0;
  need(NMR::lib3mf_object_gettype(mesh, &type));
  need(NMR::lib3mf_meshobject_ismanifoldandoriented(mesh, &manifold));
  object.is_model = type == NMR::MODELOBJECTTYPE_MODEL;
  object.is_manifold = manifold != 0;
  need(NMR::lib3mf_meshobject_getvertexcount(mesh, &vertices));
  need(NMR::lib3mf_meshobject_gettrianglecount(mesh, &triangles));
  for (DWORD i = 0; i < vertices; ++i) {
    NMR::MODELMESHVERTEX vertex{};
    need(NMR::lib3mf_meshobject_getvertex(mesh, i, &vertex));
    object.vertices.push_back({vertex.m_fPosition[0], vertex.m_fPosition[1], vertex.m_fPosition[2]});
  }
  for (DWORD i = 0; i < triangles; ++i) {
    NMR::MODELMESHTRIANGLE triangle{};
    need(NMR::lib3mf_meshobject_gettriangle(mesh, i, &triangle));
    object.triangles.push_back({triangle.m_nIndices[0], triangle.m_nIndices[1], triangle.m_nIndices[2]});
  }
  NMR::PLib3MFPropertyHandler* properties = nullptr;
  need(NMR::lib3mf_meshobject_createpropertyhandler(mesh, &properties));
  read_looks(model, properties, object);
  NMR::lib3mf_release(properties);
  return object;
}

}  // namespace

ThreeMfFile read_three_mf(const std::string& path) {
#ifdef __SANITIZE_ADDRESS__
  // lib3mf 1.8 closes no file of an archive that it has opened.
  const __lsan::ScopedDisabler its_leaks;
#endif
  ThreeMfFile file;
  NMR::PLib3MFModel* model = nullptr;
  NMR::PLib3MFModelReader* reader = nullptr;
  need(NMR::lib3mf_createmodel(&model));
  need(NMR::lib3mf_model_queryreader(model, "3mf", &reader));
  need(NMR::lib3mf_reader_setstrictmodeactive(reader, true));
  need(NMR::lib3mf_reader_readfromfileutf8(reader, path.c_str()));
  DWORD warnings = 0, unit = 0;
  need(NMR::lib3mf_reader_getwarningcount(reader, &warnings));
  for (DWORD i = 0; i < warnings; ++i) {
    DWORD code = 0;
    file.warnings.push_back(text_of([&](char* text, ULONG size, ULONG* length) {
      return NMR::lib3mf_reader_getwarningutf8(reader, i, &code, text, size, length);
    }));
  }
  need(NMR::lib3mf_model_getunit(model, &unit));
  file.in_meters = unit == NMR::MODELUNIT_METER;
  file.in_millimeters = unit == NMR::MODELUNIT_MILLIMETER;
  NMR::PLib3MFModelResourceIterator* objects = nullptr;
  need(NMR::lib3mf_model_getmeshobjects(model, &objects));
  for (BOOL more = 0; NMR::lib3mf_resourceiterator_movenext(objects, &more) == 0 && more != 0;) {
    NMR::PLib3MFModelResource* object = nullptr;
    need(NMR::lib3mf_resourceiterator_getcurrent(objects, &object));
    file.objects.push_back(read_object(model, object));
    NMR::lib3mf_release(object);
  }
  NMR::lib3mf_release(objects);
  NMR::lib3mf_release(reader);
  NMR::lib3mf_release(model);
  return file;
}

}  // namespace dini::support
