// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_WRITE_BY_LIB3MF_H
#define SEGMENT_MESH_WRITE_BY_LIB3MF_H

#include "Segmented_soup.h"

#include <ostream>
#include <stdexcept>
#include <string>

#ifdef SEGMENT_MESH_WITH_LIB3MF
#include "Byte_scanner.h"
#include "Lib3mf.h"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid.hpp>
#include <boost/uuid/uuid_io.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <vector>
#endif

namespace segment_mesh {

inline bool is_3mf(const std::string& extension) { return extension == ".3mf"; }

#ifdef SEGMENT_MESH_WITH_LIB3MF

constexpr bool has_lib3mf = true;

// Returns an archive of lib3mf, which is ZIP64, as plain ZIP, because Assimp 5 does not read ZIP64.
// An archive that is too large for plain ZIP stays as it is.
inline std::string plain_zip(const std::string& archive)
{
  const auto bytes = [](std::size_t number, int size) {
    std::string result;
    for (; size > 0; --size, number >>= 8)
      result += static_cast<char>(number & 0xFF);
    return result;
  };
  std::string result, directory;
  std::size_t entries = 0;
  for (std::size_t at = 0; archive.compare(at, 4, "PK\3\4") == 0; ++entries) {
    mesh_file::Byte_scanner numbers(archive, at + 26, false);
    const std::size_t size_of_name = numbers.number<std::uint16_t>();
    const std::size_t size_of_extra = numbers.number<std::uint16_t>();
    numbers.skip(size_of_name + 4, "a name"); // and the head of the sizes
    const std::size_t size = static_cast<std::size_t>(numbers.number<std::uint64_t>());
    const std::size_t packed_size = static_cast<std::size_t>(numbers.number<std::uint64_t>());
    if ((std::max)(archive.size(), size) > 0xFFFF0000)
      return archive;
    const std::string name = archive.substr(at + 30, size_of_name);
    const std::string entry = // for version 2.0, of 1980-01-01
      bytes(20, 2) + archive.substr(at + 6, 4) + bytes(0x210000, 4) + archive.substr(at + 14, 4) +
      bytes(packed_size, 4) + bytes(size, 4) + bytes(size_of_name, 4);
    directory += "PK\1\2" + bytes(20, 2) + entry + bytes(0, 10) + bytes(result.size(), 4) + name;
    at += 30 + size_of_name + size_of_extra;
    result += "PK\3\4" + entry + name;
    result.append(archive, at, packed_size);
    at += packed_size;
  }
  return result + directory + "PK\5\6" + bytes(0, 4) + bytes(entries, 2) + bytes(entries, 2) +
         bytes(directory.size(), 4) + bytes(result.size(), 4) + bytes(0, 2);
}

// Writes 3MF: an object for each segment that has triangles, with a material, and for each part
// that was cut an object whose components are its parts. The identifiers are hashes of what they
// stand for, so that the same mesh gives the same file.
class Lib3mf_writer
{
  typedef mesh_file::Index Index;

  // The object of a part. There is none if the part has no triangles.
  struct Object
  {
    Lib3mf instance;
    std::string identifier;
  };

  const mesh_file::Segmented_soup& mesh_;
  mesh_file::Segment_extraction extract_;
  const Lib3mf model_ = Lib3mf::model();
  const Lib3mf materials_ = model_.made(NMR::lib3mf_model_addbasematerialgroup);

  static std::string identifier_of(const std::string& content)
  {
    const boost::uuids::name_generator_sha1 generator(boost::uuids::ns::oid());
    return to_string(generator(content));
  }

  template <class T>
  static std::string bytes_of(const std::vector<T>& values)
  { return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)}; }

  // Throws if the six decimals of the numbers would lose the shape.
  void check_size() const
  {
    double extent = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      double smallest = std::numeric_limits<double>::infinity(), largest = -smallest;
      for (Index v : mesh_.soup.corners) {
        smallest = (std::min)(smallest, mesh_.soup.points[v][k]);
        largest = (std::max)(largest, mesh_.soup.points[v][k]);
      }
      extent = (std::max)(extent, largest - smallest);
    }
    if (extent > 0 && extent < 1e-3)
      throw std::runtime_error("the mesh is too small for the numbers of 3MF, millimeters with six "
                               "decimals; --unit or --scale makes it larger");
  }

  static NMR::MODELMESHVERTEX vertex(const mesh_file::Point& point)
  {
    const double largest = 1e9; // that lib3mf takes
    NMR::MODELMESHVERTEX result;
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::abs(point[k]) > largest)
        throw std::runtime_error("a coordinate is too large for the numbers of 3MF");
      result.m_fPosition[k] = static_cast<float>(point[k]);
    }
    return result;
  }

  void name(const Object& object, const std::string& name) const
  {
    object.instance.call(NMR::lib3mf_object_setnameutf8, name.c_str());
    object.instance.call(NMR::lib3mf_object_setuuidutf8, object.identifier.c_str());
  }

  void set_material(const Lib3mf& object, Index segment) const
  {
    const mesh_file::Rgb& c = mesh_.colors[segment];
    DWORD group, material;
    materials_.call(NMR::lib3mf_basematerial_getresourceid, &group);
    materials_.call(NMR::lib3mf_basematerial_addmaterialutf8,
         mesh_file::segment_name(segment).c_str(), c[0], c[1], c[2], &material);
    materials_.call(NMR::lib3mf_basematerial_setdisplaycolorrgba, material, c[0], c[1], c[2],
         BYTE(255));
    const Lib3mf properties = object.made(NMR::lib3mf_object_createdefaultpropertyhandler);
    properties.call(NMR::lib3mf_defaultpropertyhandler_setbasematerial, group, material);
  }

  Object mesh_object(Index segment)
  {
    const mesh_file::Polygon_soup soup = extract_(segment);
    std::vector<NMR::MODELMESHVERTEX> vertices;
    std::vector<NMR::MODELMESHTRIANGLE> triangles;
    for (const mesh_file::Triangle& t : mesh_file::triangles_of(soup))
      triangles.push_back({{t[0], t[1], t[2]}});
    if (triangles.empty())
      return {};
    for (const mesh_file::Point& p : soup.points)
      vertices.push_back(vertex(p));
    const std::string segment_name = mesh_file::segment_name(segment);
    Object result{model_.made(NMR::lib3mf_model_addmeshobject),
                  identifier_of(segment_name + bytes_of(vertices) + bytes_of(triangles))};
    result.instance.call(NMR::lib3mf_meshobject_setgeometry, vertices.data(),
         static_cast<DWORD>(vertices.size()), triangles.data(),
         static_cast<DWORD>(triangles.size()));
    name(result, segment_name);
    BOOL is_closed;
    result.instance.call(NMR::lib3mf_meshobject_ismanifoldandoriented, &is_closed);
    if (!is_closed)
      result.instance.call(NMR::lib3mf_object_settype, DWORD(NMR::MODELOBJECTTYPE_SURFACE));
    set_material(result.instance, segment);
    return result;
  }

  // Returns an object of those components that are not empty; an empty one if all are.
  Object components_object(const std::string& object_name, const std::vector<Object*>& components)
  {
    std::string content = object_name;
    for (const Object* c : components)
      content += c->identifier;
    if (content == object_name)
      return {};
    Object result{model_.made(NMR::lib3mf_model_addcomponentsobject), identifier_of(content)};
    name(result, object_name);
    for (const Object* c : components)
      if (c->instance) {
        const Lib3mf component = result.instance.made(NMR::lib3mf_componentsobject_addcomponent,
                                        c->instance.get(), nullptr);
        component.call(NMR::lib3mf_component_setuuidutf8,
             identifier_of(result.identifier + c->identifier).c_str());
      }
    return result;
  }

  // Returns the object of the only part without a parent, or an object of all such parts.
  Object root_object()
  {
    const std::vector<mesh_file::Part> parts = mesh_file::present_parts(mesh_);
    std::vector<Object> objects(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].segment != mesh_file::null_index)
        objects[i] = mesh_object(parts[i].segment);
    std::vector<std::vector<Object*> > components(parts.size() + 1); // the last are of the root
    for (std::size_t i = 0; i < parts.size(); ++i)
      components[parts[i].parent == mesh_file::null_index ? parts.size() : parts[i].parent]
        .push_back(&objects[i]);
    for (std::size_t i = parts.size(); i-- > 0;) // an object comes after its components
      if (parts[i].segment == mesh_file::null_index)
        objects[i] = components_object(mesh_file::part_name(parts[i]), components[i]);
    if (components.back().size() == 1)
      return std::move(*components.back()[0]);
    return components_object("segments", components.back());
  }

  // Writes bytes for lib3mf. The output itself knows whether writing failed.
  static DWORD write_bytes(BYTE* bytes, DWORD number, void* output)
  {
    static_cast<std::ostream*>(output)->write(reinterpret_cast<const char*>(bytes), number);
    return 0;
  }

  static DWORD seek(ULONG64 position, void* output)
  {
    static_cast<std::ostream*>(output)->seekp(static_cast<std::streamoff>(position));
    return 0;
  }

public:
  explicit Lib3mf_writer(const mesh_file::Segmented_soup& mesh) : mesh_(mesh), extract_(mesh) {}

  void operator()(std::ostream& out)
  {
    check_size();
    model_.call(NMR::lib3mf_model_setunit, DWORD(NMR::MODELUNIT_MILLIMETER));
    const Object root = root_object();
    if (root.instance) {
      const Lib3mf item =
        model_.made(NMR::lib3mf_model_addbuilditem, root.instance.get(), nullptr);
      item.call(NMR::lib3mf_builditem_setuuidutf8,
           identifier_of("item" + root.identifier).c_str());
    }
    model_.call(NMR::lib3mf_model_setbuilduuidutf8,
         identifier_of("build" + root.identifier).c_str());
    const Lib3mf writer = model_.made(NMR::lib3mf_model_querywriter, "3mf");
    std::ostringstream archive;
    writer.call(NMR::lib3mf_writer_writetocallback, reinterpret_cast<void*>(&write_bytes),
         reinterpret_cast<void*>(&seek), static_cast<void*>(static_cast<std::ostream*>(&archive)));
    out << plain_zip(archive.str());
  }
};

// Writes 3MF. Throws if the coordinates are too large or the mesh is too small.
inline void write_3mf(std::ostream& out, const mesh_file::Segmented_soup& mesh)
{ Lib3mf_writer{mesh}(out); }

#else

constexpr bool has_lib3mf = false;

inline void write_3mf(std::ostream&, const mesh_file::Segmented_soup&)
{ throw std::runtime_error("this build is without lib3mf"); }

#endif

} // namespace segment_mesh

#endif // SEGMENT_MESH_WRITE_BY_LIB3MF_H
