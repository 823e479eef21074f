// SPDX-License-Identifier: MIT
#include "mesh/attribute_mix.h"

#include <algorithm>
#include <utility>

namespace remesher {

namespace {

constexpr std::size_t kInfluences = 4;  // joints per vertex that glTF's first set holds

bool hasPrefix(const std::string& text, const char* prefix) { return text.rfind(prefix, 0) == 0; }

std::size_t findSemantic(const TriangleMesh& mesh, const std::string& semantic) {
  std::size_t a = 0;
  while (a < mesh.attributes.size() && mesh.attributes[a].semantic != semantic) ++a;
  return a;
}

void appendVector(const Vec3& v, std::vector<float>& out) {
  for (int k = 0; k < 3; ++k) out.push_back(float(v[k]));
}

}  // namespace

AttributeMix::AttributeMix(const TriangleMesh& input, const std::vector<std::string>& chartless)
    : input_(input) {
  const auto isOfFour = [&](std::size_t a) {
    return a < input.attributes.size() && input.attributes[a].itemSize == int{kInfluences};
  };
  for (std::size_t n = 0; n < input.attributes.size(); ++n) {
    const std::string number = std::to_string(n);
    const SkinSet set{findSemantic(input, "JOINTS_" + number),
                      findSemantic(input, "WEIGHTS_" + number)};
    if (!isOfFour(set.joints) || !isOfFour(set.weights)) break;
    skin_.push_back(set);
  }
  for (const Attribute& attribute : input.attributes)
    kinds_.push_back(kindOf(attribute, chartless));
  for (const Kind kind : kinds_)
    needsNormals_ |= kind == Kind::Unit || kind == Kind::Tangent || kind == Kind::SurfaceNormal;
}

AttributeMix::Kind AttributeMix::kindOf(const Attribute& attribute,
                                        const std::vector<std::string>& chartless) const {
  const std::string& semantic = attribute.semantic;
  const bool jumps = std::find(chartless.begin(), chartless.end(), semantic) != chartless.end();
  if (semantic == "NORMAL" && attribute.itemSize == 3)
    return jumps ? Kind::SurfaceNormal : Kind::Unit;
  for (const SkinSet& set : skin_)
    if (semantic == input_.attributes[set.joints].semantic ||
        semantic == input_.attributes[set.weights].semantic)
      return Kind::Skin;
  // A mean of two identifiers would be another identifier.
  const bool isIdentifier = hasPrefix(semantic, "_FEATURE_ID_") || hasPrefix(semantic, "_BATCHID");
  if (jumps || isIdentifier || hasPrefix(semantic, "JOINTS_")) return Kind::Nearest;
  return semantic == "TANGENT" && attribute.itemSize == 4 ? Kind::Tangent : Kind::Linear;
}

double AttributeMix::value(const Attribute& attribute, const Point& point, int k) const {
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    sum += point.weights[i] *
           double(attribute.values[std::size_t{point.vertices[i]} * attribute.itemSize + k]);
  return sum;
}

Vec3 AttributeMix::mixedVector(const Attribute& attribute, const Point& point) const {
  return {value(attribute, point, 0), value(attribute, point, 1), value(attribute, point, 2)};
}

void AttributeMix::appendTangent(std::size_t a, const Point& point, const Vec3& normal,
                                 std::vector<float>& out) const {
  const Attribute& attribute = input_.attributes[a];
  Vec3 tangent = mixedVector(attribute, point);
  tangent -= tangent.dot(normal) * normal;
  if (!(tangent.squaredNorm() > 1e-12)) tangent = normal.unitOrthogonal();
  appendVector(tangent.normalized(), out);
  // The side of the chart is the same at all three corners.
  out.push_back(attribute.values[std::size_t{point.vertices[0]} * 4 + 3]);
}

// Weight per joint over the three corners; the strongest four, scaled to sum to one. The first set
// holds them and further sets are zero, as are joints whose weight is too small for a number.
void AttributeMix::appendSkin(const Point& point, std::vector<Attribute>& values) const {
  std::vector<std::pair<float, double>> influences;
  for (const SkinSet& set : skin_)
    for (int i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < kInfluences; ++k) {
        const std::size_t at = point.vertices[i] * kInfluences + k;
        const float joint = input_.attributes[set.joints].values[at];
        const double weight = point.weights[i] * input_.attributes[set.weights].values[at];
        if (!(weight > 0)) continue;
        const auto known = std::find_if(influences.begin(), influences.end(),
                                        [&](const auto& other) { return other.first == joint; });
        if (known == influences.end())
          influences.emplace_back(joint, weight);
        else
          known->second += weight;
      }
  std::sort(influences.begin(), influences.end(), [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second > b.second : a.first < b.first;
  });
  influences.resize(kInfluences, {0.0F, 0.0});
  double sum = 0;
  for (const auto& [joint, weight] : influences) sum += weight;
  for (std::size_t n = 0; n < skin_.size(); ++n)
    for (std::size_t k = 0; k < kInfluences; ++k) {
      const bool held = n == 0 && sum > 0;
      const float weight = held ? float(influences[k].second / sum) : 0.0F;
      values[skin_[n].joints].values.push_back(weight > 0 ? influences[k].first : 0.0F);
      values[skin_[n].weights].values.push_back(weight);
    }
}

void AttributeMix::append(const Point& point, std::vector<Attribute>& values) const {
  int nearest = 0;
  point.weights.maxCoeff(&nearest);
  const std::size_t normals = findSemantic(input_, "NORMAL");
  for (std::size_t a = 0; a < kinds_.size(); ++a) {
    const Attribute& attribute = input_.attributes[a];
    std::vector<float>& out = values[a].values;
    switch (kinds_[a]) {
      case Kind::Linear:
        for (int k = 0; k < attribute.itemSize; ++k)
          out.push_back(float(value(attribute, point, k)));
        break;
      case Kind::Unit: {
        const Vec3 mixed = mixedVector(attribute, point);
        appendVector((mixed.isZero(0) ? point.normal : mixed).normalized(), out);
        break;
      }
      case Kind::SurfaceNormal:
        appendVector(point.normal.normalized(), out);
        break;
      case Kind::Tangent: {
        const bool own = normals < kinds_.size() && kinds_[normals] == Kind::Unit;
        const Vec3 normal = own ? mixedVector(input_.attributes[normals], point) : point.normal;
        appendTangent(a, point, normal.normalized(), out);
        break;
      }
      case Kind::Nearest:
        for (int k = 0; k < attribute.itemSize; ++k)
          out.push_back(
              attribute.values[std::size_t{point.vertices[nearest]} * attribute.itemSize + k]);
        break;
      case Kind::Skin:
        break;
    }
  }
  if (!skin_.empty()) appendSkin(point, values);
}

}  // namespace remesher
