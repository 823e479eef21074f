// SPDX-License-Identifier: MIT
// How JavaScript spells the choices.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "remesher.h"

namespace remesher {

template <class E, std::size_t n>
using Names = std::array<std::pair<std::string_view, E>, n>;

inline constexpr Names<Scheme, 2> kSchemes = {{{"best", Scheme::Best}, {"rounds", Scheme::Rounds}}};
inline constexpr Names<Prefer, 3> kPrefers = {
    {{"auto", Prefer::Auto}, {"even", Prefer::Even}, {"shape", Prefer::Shape}}};
inline constexpr Names<Quality, 2> kQualities = {
    {{"draft", Quality::Draft}, {"best", Quality::Best}}};
inline constexpr Names<Projection, 2> kProjections = {
    {{"patches", Projection::Patches}, {"current", Projection::Current}}};
inline constexpr Names<Fidelity, 3> kFidelities = {
    {{"strict", Fidelity::Strict}, {"loose", Fidelity::Loose}, {"fold", Fidelity::Fold}}};
inline constexpr Names<Boundary, 2> kBoundaries = {
    {{"resample", Boundary::Resample}, {"keep", Boundary::Keep}}};
inline constexpr Names<Textures, 4> kTextures = {{{"auto", Textures::Auto},
                                                  {"keep", Textures::Keep},
                                                  {"drop", Textures::Drop},
                                                  {"bake", Textures::Bake}}};
inline constexpr Names<TextureFormat, 3> kTextureFormats = {
    {{"png", TextureFormat::Png}, {"jpeg", TextureFormat::Jpeg}, {"webp", TextureFormat::Webp}}};
inline constexpr Names<Symmetry, 9> kSymmetries = {{{"auto", Symmetry::Auto},
                                                    {"off", Symmetry::Off},
                                                    {"x", Symmetry::X},
                                                    {"y", Symmetry::Y},
                                                    {"z", Symmetry::Z},
                                                    {"xy", Symmetry::XY},
                                                    {"xz", Symmetry::XZ},
                                                    {"yz", Symmetry::YZ},
                                                    {"xyz", Symmetry::XYZ}}};
inline constexpr Names<Repair, 5> kRepairs = {{{"off", Repair::Off},
                                               {"holes", Repair::Holes},
                                               {"solid", Repair::Solid},
                                               {"wrap", Repair::Wrap},
                                               {"auto", Repair::Auto}}};
inline constexpr Names<Sheets, 2> kSheets = {
    {{"thicken", Sheets::Thicken}, {"drop", Sheets::Drop}}};
inline constexpr Names<BooleanOperation, 3> kBooleans = {
    {{"union", BooleanOperation::Union},
     {"subtract", BooleanOperation::Subtract},
     {"intersect", BooleanOperation::Intersect}}};
inline constexpr Names<Stopped, 4> kStopped = {{{"target", Stopped::Target},
                                                {"fidelity", Stopped::Fidelity},
                                                {"max-error", Stopped::MaxError}}};

inline constexpr Names<Severity, 3> kSeverities = {
    {{"note", Severity::Note}, {"loss", Severity::Loss}, {"fault", Severity::Fault}}};

inline constexpr Names<GuideKind, 2> kGuideKinds = {
    {{"direction", GuideKind::Direction}, {"loop", GuideKind::Loop}}};

constexpr const auto& namesOf(GuideKind) { return kGuideKinds; }
constexpr const auto& namesOf(Scheme) { return kSchemes; }
constexpr const auto& namesOf(Prefer) { return kPrefers; }
constexpr const auto& namesOf(Quality) { return kQualities; }
constexpr const auto& namesOf(Projection) { return kProjections; }
constexpr const auto& namesOf(Fidelity) { return kFidelities; }
constexpr const auto& namesOf(Boundary) { return kBoundaries; }
constexpr const auto& namesOf(Textures) { return kTextures; }
constexpr const auto& namesOf(Symmetry) { return kSymmetries; }
constexpr const auto& namesOf(Repair) { return kRepairs; }
constexpr const auto& namesOf(Sheets) { return kSheets; }
constexpr const auto& namesOf(TextureFormat) { return kTextureFormats; }

template <class E, std::size_t n>
constexpr std::string_view nameOf(const Names<E, n>& names, E value) {
  for (const auto& [name, known] : names)
    if (known == value) return name;
  return {};
}

}  // namespace remesher
