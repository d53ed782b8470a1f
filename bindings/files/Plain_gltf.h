// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_PLAIN_GLTF_H
#define SEGMENT_MESH_PLAIN_GLTF_H

#include "Byte_scanner.h"
#include "Text_scanner.h"

#include <nlohmann/json.hpp>

#ifdef SEGMENT_MESH_WITH_DRACO
#include <draco/compression/decode.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace segment_mesh {

// A file of glTF 2 in the form that Assimp reads: with points in float, which are not compressed,
// and with a node for each instance, and without animations. The file may come from a stranger.
class Plain_gltf
{
  typedef nlohmann::json Json;
  typedef std::function<std::string(const std::string&)> Reader;

  static constexpr std::size_t float_type = 5126, index_type = 5125; // of 32 bits

  const Reader read_;
  std::string_view text_, binary_;
  Json json_;
  std::map<std::size_t, std::string> buffers_; // that were read
  std::map<std::size_t, std::size_t> plain_accessors_; // by the accessors that they replace
  std::string data_; // of the plain accessors

  [[noreturn]] static void fail(const std::string& message) { throw std::runtime_error(message); }

  static std::size_t number(const Json& object, const char* key)
  {
    const Json& result = object.at(key);
    if (!result.is_number_unsigned())
      fail(std::string("its description has a wrong '") + key + "'");
    return result.get<std::size_t>();
  }

  static std::size_t number(const Json& object, const char* key, std::size_t otherwise)
  { return object.contains(key) ? number(object, key) : otherwise; }

  // Finds the description and the data, and returns false for binary glTF of another version than
  // 2. The description may not be filled up to a multiple of four bytes.
  bool split(std::string_view file)
  {
    text_ = file;
    if (file.substr(0, 4) != "glTF")
      return true;
    mesh_file::Byte_scanner scan(file, 4, false);
    const bool is_version_2 = scan.number<std::uint32_t>("the version") == 2;
    scan.skip(4, "the size of the file");
    const std::size_t size = scan.number<std::uint32_t>("the size of the description");
    scan.skip(4, "the description");
    text_ = file.substr(scan.position(), size);
    scan.skip(text_.size(), "the description");
    const std::string_view mark("BIN\0", 4);
    if (scan.remaining() >= 8 && file.substr(scan.position() + 4, 4) != mark)
      scan.skip((4 - size % 4) % 4, "the data");
    if (scan.remaining() >= 8 && file.substr(scan.position() + 4, 4) == mark) {
      const std::size_t size_of_data = scan.number<std::uint32_t>();
      binary_ = file.substr(scan.position() + 4, size_of_data);
    }
    return is_version_2;
  }

  // Returns the value of the description, also if a name in it is not in UTF-8.
  static Json parsed(std::string text)
  {
    Json result = Json::parse(text, nullptr, false);
    if (result.is_discarded()) {
      std::replace_if(text.begin(), text.end(), [](char c) { return (c & 0x80) != 0; }, '?');
      result = Json::parse(text, nullptr, false);
    }
    return result;
  }

  // Returns whether Assimp reads the same mesh without knowing the extension.
  static bool is_harmless(const std::string& extension)
  {
    static const char* const parts[] = {
      "material", "texture", "light", "camera", "animation", "audio", "visibility", "hover",
      "select", "interactivity", "physics", "collision", "xmp", "meta", "feature", "articulation",
      "lod", "rtc", "packing", "techniques", "vrm", "manifold", "outline", "ngon"};
    const std::string name = mesh_file::lower_case(extension);
    return std::any_of(std::begin(parts), std::end(parts), [&](const char* part)
                       { return name.find(part) != std::string::npos; });
  }

  void check_extensions() const
  {
    for (const Json& value : json_.value("extensionsRequired", Json::array())) {
      const std::string name = value.get<std::string>();
      const bool is_compression = name == "EXT_meshopt_compression" ||
                                  name == "KHR_meshopt_compression" ||
                                  name == "KHR_draco_mesh_compression";
#ifdef SEGMENT_MESH_WITH_DRACO
      if (name == "KHR_draco_mesh_compression")
        continue;
#endif
      if (name != "KHR_mesh_quantization" && name != "EXT_mesh_gpu_instancing" &&
          !is_harmless(name))
        fail("it needs the extension " + mesh_file::in_quotes(name, 60) +
             " of glTF, which is not read; " +
             (is_compression
                ? "the command gltf-transform copy IN.glb OUT.glb of @gltf-transform/cli decodes it"
                : "export the mesh without it"));
    }
  }

  static std::string decoded_base64(std::string_view text)
  {
    static const std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string result;
    std::uint32_t bits = 0;
    std::size_t number_of_digits = 0;
    for (char c : text.substr(0, text.find('='))) {
      const std::size_t digit = digits.find(c);
      if (digit == std::string_view::npos)
        fail("its data in the description are no base64");
      bits = bits << 6 | static_cast<std::uint32_t>(digit);
      if (++number_of_digits % 4 != 1)
        result += static_cast<char>(bits >> (6 - 2 * ((number_of_digits - 1) % 4)) & 0xff);
    }
    return result;
  }

  std::string_view buffer(std::size_t index)
  {
    const Json& buffer = json_.at("buffers").at(index);
    if (!buffer.contains("uri"))
      return index == 0 ? binary_ : std::string_view();
    const auto [place, is_new] = buffers_.emplace(index, "");
    if (is_new) {
      const std::string address = buffer.at("uri").get<std::string>(), mark = ";base64,";
      const std::size_t begin = address.find(mark);
      place->second = address.compare(0, 5, "data:") != 0 || begin == std::string::npos
        ? read_(address)
        : decoded_base64(std::string_view(address).substr(begin + mark.size()));
    }
    return place->second;
  }

  // Returns the bytes of a buffer view.
  std::string_view bytes(const Json& view)
  {
    const std::string_view all = buffer(number(view, "buffer"));
    const std::size_t begin = number(view, "byteOffset", 0), size = number(view, "byteLength");
    if (begin > all.size() || size > all.size() - begin)
      fail("its description and its data contradict each other");
    return all.substr(begin, size);
  }

  // Calls a function with a number of a type of glTF.
  template <class Function>
  static auto with_number_of(std::size_t type, const Function& f)
  {
    switch (type) {
      case 5120: return f(std::int8_t());
      case 5121: return f(std::uint8_t());
      case 5122: return f(std::int16_t());
      case 5123: return f(std::uint16_t());
      case float_type: return f(float());
      default: fail("its points have a wrong type");
    }
  }

  static float largest(std::size_t type)
  {
    return with_number_of(type, [](auto number) -> float
      { return (std::numeric_limits<decltype(number)>::max)(); });
  }

  static std::size_t dimension(const Json& accessor)
  {
    const std::string type = accessor.at("type").get<std::string>();
    if (type != "VEC2" && type != "VEC3" && type != "VEC4")
      fail("its points are no vectors");
    return static_cast<std::size_t>(type[3] - '0');
  }

  static bool is_normalized(const Json& accessor)
  {
    return accessor.value("normalized", false) &&
           number(accessor, "componentType") != float_type;
  }

  // Returns the coordinates of all vectors of an accessor.
  std::vector<float> vectors(const Json& accessor)
  {
    const std::size_t type = number(accessor, "componentType");
    const std::size_t count = number(accessor, "count");
    const std::size_t size = with_number_of(type, [](auto number) { return sizeof number; });
    const std::size_t size_of_vector = dimension(accessor) * size;
    if (accessor.contains("sparse"))
      fail("it has sparse points that are no floats; the command gltf-transform dequantize IN.glb "
           "OUT.glb of @gltf-transform/cli makes floats of them");
    const Json& view = json_.at("bufferViews").at(number(accessor, "bufferView"));
    const std::string_view all = bytes(view);
    const std::size_t begin = number(accessor, "byteOffset", 0);
    std::size_t stride = number(view, "byteStride", 0);
    if (stride == 0)
      stride = size_of_vector;
    if (begin > all.size() ||
        (count > 0 && (size_of_vector > all.size() - begin ||
                       (count - 1) > (all.size() - begin - size_of_vector) / stride)))
      fail("its description and its data contradict each other");
    const float divisor = is_normalized(accessor) ? largest(type) : 1;
    std::vector<float> result;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < size_of_vector; k += size) {
        mesh_file::Byte_scanner scan(all, begin + i * stride + k, false);
        const float x = with_number_of(type, [&](auto number) -> float
          { return scan.number<decltype(number)>(); }) / divisor;
        result.push_back(divisor == 1 ? x : (std::max)(x, -1.f));
      }
    return result;
  }

  // Adds an accessor with its own data, and returns its index.
  template <class Number>
  std::size_t add_accessor(std::size_t component_type, const std::string& type, std::size_t count,
                           const std::vector<Number>& numbers)
  {
    const std::size_t size = numbers.size() * sizeof(Number);
    json_["bufferViews"].push_back(
      {{"buffer", json_["buffers"].size()}, {"byteOffset", data_.size()}, {"byteLength", size}});
    json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                  {"componentType", component_type}, {"count", count},
                                  {"type", type}});
    data_.append(reinterpret_cast<const char*>(numbers.data()), size);
    return json_["accessors"].size() - 1;
  }

  // Returns the index of an accessor with the same vectors in float.
  std::size_t plain_accessor(std::size_t index)
  {
    const Json accessor = json_.at("accessors").at(index);
    if (number(accessor, "componentType") == float_type)
      return index;
    const auto [place, is_new] = plain_accessors_.emplace(index, 0);
    if (is_new)
      place->second = add_accessor(float_type, accessor.at("type").get<std::string>(),
                                   number(accessor, "count"), vectors(accessor));
    return place->second;
  }

#ifdef SEGMENT_MESH_WITH_DRACO
  // Returns the index of an accessor with the vectors of an attribute of Draco.
  std::size_t decoded_accessor(const draco::Mesh& mesh, std::size_t id, const Json& accessor)
  {
    const draco::PointAttribute* const attribute =
      id < std::numeric_limits<std::uint32_t>::max()
        ? mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id)) : nullptr;
    if (!attribute)
      fail("its data of Draco contradict its description");
    const std::size_t d = dimension(accessor);
    // Draco itself divides the numbers of an attribute that it knows to be normalized.
    const float divisor = is_normalized(accessor) && !attribute->normalized()
      ? largest(number(accessor, "componentType")) : 1;
    std::vector<float> numbers;
    numbers.reserve(d * mesh.num_points());
    for (draco::PointIndex i(0); i < mesh.num_points(); ++i) {
      float vector[4] = {};
      const draco::AttributeValueIndex value = attribute->mapped_index(i);
      if (value.value() >= attribute->size() ||
          !attribute->ConvertValue<float>(value, static_cast<std::int8_t>(d), vector))
        fail("its data of Draco are damaged");
      for (std::size_t k = 0; k < d; ++k)
        numbers.push_back(vector[k] / divisor);
    }
    return add_accessor(float_type, accessor.at("type").get<std::string>(), mesh.num_points(),
                        numbers);
  }

  // Decodes the triangles of a primitive and what else is left of its attributes.
  void decode(Json& primitive)
  {
    const Json extension = primitive["extensions"]["KHR_draco_mesh_compression"];
    const std::string_view all = bytes(json_.at("bufferViews").at(number(extension, "bufferView")));
    draco::DecoderBuffer buffer;
    buffer.Init(all.data(), all.size());
    auto result = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (!result.ok())
      fail("its data of Draco are damaged");
    const std::unique_ptr<draco::Mesh> mesh = std::move(result).value();
    const Json& ids = extension.at("attributes");
    const Json attributes = primitive["attributes"];
    for (const auto& [name, index] : attributes.items())
      if (ids.contains(name))
        primitive["attributes"][name] =
          decoded_accessor(*mesh, number(ids, name.c_str()),
                           json_.at("accessors").at(number(attributes, name.c_str())));
    std::vector<std::uint32_t> corners;
    corners.reserve(3 * std::size_t(mesh->num_faces()));
    for (draco::FaceIndex f(0); f < mesh->num_faces(); ++f)
      for (const draco::PointIndex& v : mesh->face(f))
        corners.push_back(v.value());
    primitive["indices"] = add_accessor(index_type, "SCALAR", corners.size(), corners);
    primitive["mode"] = 4; // triangles, also if they were strips
  }
#endif

  // Keeps what meshes need: points, normals and texture coordinates.
  void make_plain(Json& primitive)
  {
    primitive.erase("targets");
    Json attributes = Json::object();
    for (const auto& [name, index] : primitive.at("attributes").items())
      if (name == "POSITION" || name == "NORMAL" ||
          (name.size() == 10 && name.compare(0, 9, "TEXCOORD_") == 0))
        attributes[name] = index;
    primitive["attributes"] = attributes;
#ifdef SEGMENT_MESH_WITH_DRACO
    if (primitive.contains("/extensions/KHR_draco_mesh_compression"_json_pointer))
      decode(primitive);
#endif
    primitive.erase("extensions");
    for (auto& [name, index] : primitive["attributes"].items())
      index = plain_accessor(number(primitive["attributes"], name.c_str()));
  }

  // Replaces the mesh of a node by nodes below it with this mesh, one for each instance.
  void add_instances(std::size_t index)
  {
    const Json node = json_["nodes"][index];
    const Json instances =
      node.at("/extensions/EXT_mesh_gpu_instancing/attributes"_json_pointer);
    const std::pair<const char*, const char*> places[] = {
      {"TRANSLATION", "translation"}, {"ROTATION", "rotation"}, {"SCALE", "scale"}};
    std::vector<Json> nodes;
    for (const auto& [attribute, place] : places) {
      if (!instances.contains(attribute))
        continue;
      const Json& accessor = json_.at("accessors").at(number(instances, attribute));
      const std::vector<float> numbers = vectors(accessor);
      const std::size_t d = dimension(accessor), count = numbers.size() / d;
      if (d != (place == std::string("rotation") ? 4 : 3) ||
          (!nodes.empty() && nodes.size() != count))
        fail("its description has wrong instances");
      nodes.resize(count, {{"mesh", node.at("mesh")}, {"name", node.value("name", "")}});
      for (std::size_t i = 0; i < count; ++i)
        nodes[i][place] = std::vector<float>(numbers.begin() + static_cast<std::ptrdiff_t>(i * d),
                                             numbers.begin() +
                                               static_cast<std::ptrdiff_t>(i * d + d));
    }
    for (Json& n : nodes) {
      json_["nodes"][index]["children"].push_back(json_["nodes"].size());
      json_["nodes"].push_back(std::move(n));
    }
    json_["nodes"][index].erase("mesh");
  }

  void make_plain()
  {
    check_extensions();
    for (const char* unused : {"animations", "skins", "cameras"})
      json_.erase(unused);
    if (json_.contains("meshes"))
      for (Json& mesh : json_["meshes"])
        for (Json& primitive : mesh.at("primitives"))
          make_plain(primitive);
    const std::size_t number_of_nodes = json_.contains("nodes") ? json_["nodes"].size() : 0;
    for (std::size_t i = 0; i < number_of_nodes; ++i) {
      Json& node = json_["nodes"].at(i);
      for (const char* unused : {"skin", "camera", "weights"})
        node.erase(unused);
      if (node.contains("mesh") &&
          node.contains("/extensions/EXT_mesh_gpu_instancing"_json_pointer))
        add_instances(i);
      json_["nodes"][i].erase("extensions");
    }
    if (!binary_.empty() && json_.contains("buffers") && !json_["buffers"].empty() &&
        !json_["buffers"][0].contains("uri"))
      json_["buffers"][0] = {{"uri", binary_address()}, {"byteLength", binary_.size()}};
    if (!data_.empty())
      json_["buffers"].push_back({{"uri", data_address()}, {"byteLength", data_.size()}});
  }

public:
  // Takes the contents of a file, which must outlive this object, and a function that returns the
  // contents of a file that it names.
  Plain_gltf(std::string_view file, Reader read) : read_(std::move(read))
  {
    const bool is_version_2 = split(file);
    json_ = parsed(std::string(text_));
    if (is_version_2 && json_.is_discarded())
      fail("its description is no JSON");
    try {
      const std::string version = is_version_2 && json_.is_object()
        ? json_.value("/asset/version"_json_pointer, "") : "";
      if (version.substr(0, 1) == "2")
        make_plain();
      else
        json_ = Json();
    }
    catch (const Json::exception&) {
      fail("its description is no valid glTF");
    }
  }

  // Returns whether the file is of glTF 2. Any other file has no description.
  bool is_version_2() const { return !json_.is_null(); }

  std::string description() const { return json_.dump(); }
  std::string_view binary() const { return binary_; }
  const std::string& data() const { return data_; }

  // Returns the address of `binary()` in the description.
  static std::string binary_address() { return "*binary"; }
  static std::string data_address() { return "*data"; }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_PLAIN_GLTF_H
