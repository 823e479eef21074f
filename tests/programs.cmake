# SPDX-License-Identifier: MIT
# The native programs: unit tests, the judge of the benchmark, what developers run by hand.
add_executable(unit_tests
  tests/unit/arrangement/arrangement_test.cpp
  tests/unit/arrangement/dyadic_test.cpp
  tests/unit/arrangement/parted_fans_test.cpp
  tests/unit/arrangement/points_test.cpp
  tests/unit/arrangement/sheet_triangulation_test.cpp
  tests/unit/arrangement/snapping_test.cpp
  tests/unit/bake_test.cpp
  tests/unit/base/diagnostics_test.cpp
  tests/unit/base/legible_test.cpp
  tests/unit/base/patience_test.cpp
  tests/unit/base/phase_clock_test.cpp
  tests/unit/base/place_test.cpp
  tests/unit/base/sort_pairs_test.cpp
  tests/unit/base/versioned_queue_test.cpp
  tests/unit/boolean_test.cpp
  tests/unit/contact/common_faces_test.cpp
  tests/unit/geometry/distance_sampler_test.cpp
  tests/unit/geometry/divided_edges_test.cpp
  tests/unit/geometry/extent_test.cpp
  tests/unit/geometry/fast_trigonometry_test.cpp
  tests/unit/geometry/mesh_tree_test.cpp
  tests/unit/geometry/piecewise_test.cpp
  tests/unit/geometry/polar_map_test.cpp
  tests/unit/geometry/polygon_test.cpp
  tests/unit/geometry/predicates_test.cpp
  tests/unit/geometry/quad_facing_test.cpp
  tests/unit/geometry/quad_test.cpp
  tests/unit/geometry/ray_crossings_test.cpp
  tests/unit/geometry/triangle_grid_test.cpp
  tests/unit/geometry/triangle_meeting_test.cpp
  tests/unit/geometry/triangle_test.cpp
  tests/unit/geometry/triangle_tree_test.cpp
  tests/unit/io/contents_test.cpp
  tests/unit/io/formats_test.cpp
  tests/unit/io/gltf/gltf_encoder_test.cpp
  tests/unit/io/gltf/gltf_errors_test.cpp
  tests/unit/io/gltf/gltf_reader_test.cpp
  tests/unit/io/gltf/gltf_shared_levels_test.cpp
  tests/unit/io/gltf/gltf_union_test.cpp
  tests/unit/io/gltf/gltf_writer_test.cpp
  tests/unit/io/gltf/tree/gltf_extensions_test.cpp
  tests/unit/io/gltf/tree/gltf_levels_test.cpp
  tests/unit/io/gltf/tree/gltf_pointers_test.cpp
  tests/unit/io/model/bake_test.cpp
  tests/unit/io/model/byte_reader_test.cpp
  tests/unit/io/model/companions_test.cpp
  tests/unit/io/model/conventions_test.cpp
  tests/unit/io/model/named_bodies_test.cpp
  tests/unit/io/model/near_origin_test.cpp
  tests/unit/io/model/resources_test.cpp
  tests/unit/io/model/wedges_test.cpp
  tests/unit/io/named/abaqus_test.cpp
  tests/unit/io/named/gmsh_test.cpp
  tests/unit/io/named/threemf_test.cpp
  tests/unit/io/named/vtu_test.cpp
  tests/unit/io/ply/ply_test.cpp
  tests/unit/io/stl/stl_test.cpp
  tests/unit/io/text/mtl_test.cpp
  tests/unit/io/text/obj_test.cpp
  tests/unit/io/text/off_test.cpp
  tests/unit/io/text/text_scanner_test.cpp
  tests/unit/io/text/xml_scanner_test.cpp
  tests/unit/jobs/angle_number_test.cpp
  tests/unit/jobs/checks/crossing_check_test.cpp
  tests/unit/jobs/checks/option_checks_test.cpp
  tests/unit/jobs/checks/precision_test.cpp
  tests/unit/jobs/checks/quad_checks_test.cpp
  tests/unit/jobs/checks/repair_room_test.cpp
  tests/unit/jobs/checks/result_check_test.cpp
  tests/unit/jobs/checks/wanted_check_test.cpp
  tests/unit/jobs/checks/whole_steps_test.cpp
  tests/unit/jobs/dropping_test.cpp
  tests/unit/jobs/face_budget_test.cpp
  tests/unit/jobs/fewest_vertices_test.cpp
  tests/unit/jobs/inspected_parts_test.cpp
  tests/unit/jobs/level_switches_test.cpp
  tests/unit/jobs/open_number_test.cpp
  tests/unit/jobs/part_repair_test.cpp
  tests/unit/jobs/parts/common_frame_test.cpp
  tests/unit/jobs/parts/drawing_order_test.cpp
  tests/unit/jobs/parts/part_frames_test.cpp
  tests/unit/jobs/parts/part_guides_test.cpp
  tests/unit/jobs/parts/part_joining_test.cpp
  tests/unit/jobs/parts/part_lengths_test.cpp
  tests/unit/jobs/parts/part_places_test.cpp
  tests/unit/jobs/parts/part_report_test.cpp
  tests/unit/jobs/parts/part_targets_test.cpp
  tests/unit/jobs/parts/part_unions_test.cpp
  tests/unit/jobs/parts/quad_diagonals_test.cpp
  tests/unit/jobs/pixel_levels_test.cpp
  tests/unit/jobs/region_run_test.cpp
  tests/unit/jobs/thinned_parts_test.cpp
  tests/unit/jobs/touching_parts_test.cpp
  tests/unit/main.cpp
  tests/unit/measure/edge_report_test.cpp
  tests/unit/measure/hausdorff_test.cpp
  tests/unit/measure/mesh_report_test.cpp
  tests/unit/measure/quad_report_test.cpp
  tests/unit/measure/self_intersections_test.cpp
  tests/unit/mesh/canonical_order_test.cpp
  tests/unit/mesh/components_test.cpp
  tests/unit/mesh/coordinate_step_test.cpp
  tests/unit/mesh/edge_groups_test.cpp
  tests/unit/mesh/euler_operators_test.cpp
  tests/unit/mesh/given_order_test.cpp
  tests/unit/mesh/halfedge_mesh_check_test.cpp
  tests/unit/mesh/halfedge_mesh_test.cpp
  tests/unit/mesh/handles_test.cpp
  tests/unit/mesh/hubs_test.cpp
  tests/unit/mesh/joining_test.cpp
  tests/unit/mesh/joints_test.cpp
  tests/unit/mesh/manifold_cut_test.cpp
  tests/unit/mesh/mesh_builder_test.cpp
  tests/unit/mesh/orientation_test.cpp
  tests/unit/mesh/quad_loops_test.cpp
  tests/unit/mesh/shortest_paths_test.cpp
  tests/unit/mesh/space_order_test.cpp
  tests/unit/mesh/star_passes_test.cpp
  tests/unit/mesh/submesh_test.cpp
  tests/unit/mesh/topology_test.cpp
  tests/unit/mesh/used_vertices_test.cpp
  tests/unit/mesh/welding_test.cpp
  tests/unit/original/curves/curve_simplification_test.cpp
  tests/unit/original/curves/feature_curves_test.cpp
  tests/unit/original/curves/feature_detection_test.cpp
  tests/unit/original/curves/flat_regions_test.cpp
  tests/unit/original/curves/seams_test.cpp
  tests/unit/original/curves/shape_angles_test.cpp
  tests/unit/original/curves/spikes_test.cpp
  tests/unit/original/patches/disk_parameterization_test.cpp
  tests/unit/original/patches/disk_patch_test.cpp
  tests/unit/original/patches/face_cells_test.cpp
  tests/unit/original/patches/patch_atlas_test.cpp
  tests/unit/original/patches/point_location_test.cpp
  tests/unit/original/surface/accurate_sizes_test.cpp
  tests/unit/original/surface/boundary_places_test.cpp
  tests/unit/original/surface/curvature_test.cpp
  tests/unit/original/surface/original_surface_test.cpp
  tests/unit/original/surface/original_tree_test.cpp
  tests/unit/original/surface/surface_walk_test.cpp
  tests/unit/remesh/accuracy/bound_error_test.cpp
  tests/unit/remesh/accuracy/fit_test.cpp
  tests/unit/remesh/accuracy/lower_hausdorff_test.cpp
  tests/unit/remesh/accuracy/narrow_sizes_test.cpp
  tests/unit/remesh/accuracy/narrowest_test.cpp
  tests/unit/remesh/accuracy/needles_test.cpp
  tests/unit/remesh/accuracy/poor_regions_test.cpp
  tests/unit/remesh/accuracy/refine_excess_test.cpp
  tests/unit/remesh/accuracy/uncross_test.cpp
  tests/unit/remesh/conforming/conforming_test.cpp
  tests/unit/remesh/conforming/exchange_test.cpp
  tests/unit/remesh/conforming/unrolled_test.cpp
  tests/unit/remesh/gate/angles_test.cpp
  tests/unit/remesh/gate/crossing_guard_test.cpp
  tests/unit/remesh/gate/crossings_test.cpp
  tests/unit/remesh/gate/error_bound_test.cpp
  tests/unit/remesh/gate/excess_test.cpp
  tests/unit/remesh/gate/fidelity_test.cpp
  tests/unit/remesh/gate/sharp_tips_test.cpp
  tests/unit/remesh/ground/decimate_test.cpp
  tests/unit/remesh/ground/proxy_test.cpp
  tests/unit/remesh/guides/imprint_test.cpp
  tests/unit/remesh/guides/kept_guides_test.cpp
  tests/unit/remesh/guides/surface_guides_test.cpp
  tests/unit/remesh/operators/local_operators_test.cpp
  tests/unit/remesh/operators/projection_test.cpp
  tests/unit/remesh/operators/shift_test.cpp
  tests/unit/remesh/operators/smoothing_test.cpp
  tests/unit/remesh/operators/working_mesh_test.cpp
  tests/unit/remesh/quads/base_meshes_test.cpp
  tests/unit/remesh/quads/counting_test.cpp
  tests/unit/remesh/quads/extract/closing_test.cpp
  tests/unit/remesh/quads/extract/extraction_test.cpp
  tests/unit/remesh/quads/extract/holes_test.cpp
  tests/unit/remesh/quads/extract/opening_test.cpp
  tests/unit/remesh/quads/field/cross_field_test.cpp
  tests/unit/remesh/quads/field/guide_directions_test.cpp
  tests/unit/remesh/quads/map/cut_test.cpp
  tests/unit/remesh/quads/map/integer_rows_test.cpp
  tests/unit/remesh/quads/map/loop_search_test.cpp
  tests/unit/remesh/quads/map/map_loops_test.cpp
  tests/unit/remesh/quads/map/near_passes_test.cpp
  tests/unit/remesh/quads/map/rounding_test.cpp
  tests/unit/remesh/quads/map/seamless_map_test.cpp
  tests/unit/remesh/quads/map/seamless_system_test.cpp
  tests/unit/remesh/quads/map/untangle_test.cpp
  tests/unit/remesh/quads/mesh/joint_sides_test.cpp
  tests/unit/remesh/quads/mesh/quad_borders_test.cpp
  tests/unit/remesh/quads/mesh/quad_check_test.cpp
  tests/unit/remesh/quads/mesh/quad_distance_test.cpp
  tests/unit/remesh/quads/mesh/triangulated_test.cpp
  tests/unit/remesh/quads/pair/box_quads_test.cpp
  tests/unit/remesh/quads/pair/pairing_test.cpp
  tests/unit/remesh/quads/quad_sizes_test.cpp
  tests/unit/remesh/quads/quads_test.cpp
  tests/unit/remesh/quads/shape/chords_test.cpp
  tests/unit/remesh/quads/shape/collapse_test.cpp
  tests/unit/remesh/quads/shape/curve_lengths_test.cpp
  tests/unit/remesh/quads/shape/fair_system_test.cpp
  tests/unit/remesh/quads/shape/fairing_test.cpp
  tests/unit/remesh/quads/shape/mending_test.cpp
  tests/unit/remesh/quads/shape/plane_sides_test.cpp
  tests/unit/remesh/quads/shape/quad_tips_test.cpp
  tests/unit/remesh/quads/shape/rewiring_test.cpp
  tests/unit/remesh/quads/shape/smoothing_test.cpp
  tests/unit/remesh/quads/shape/thin_protrusions_test.cpp
  tests/unit/remesh/schemes/chart_needs_test.cpp
  tests/unit/remesh/schemes/chooser_test.cpp
  tests/unit/remesh/schemes/conformed_test.cpp
  tests/unit/remesh/schemes/curve_choice_test.cpp
  tests/unit/remesh/schemes/edge_limits_test.cpp
  tests/unit/remesh/schemes/follow_test.cpp
  tests/unit/remesh/schemes/guided_test.cpp
  tests/unit/remesh/schemes/kept_edges_test.cpp
  tests/unit/remesh/schemes/mirrored_test.cpp
  tests/unit/remesh/schemes/part_by_part_test.cpp
  tests/unit/remesh/schemes/remesh_test.cpp
  tests/unit/remesh/schemes/rounds_test.cpp
  tests/unit/remesh/schemes/targets_test.cpp
  tests/unit/remesh/schemes/uncrossed_test.cpp
  tests/unit/remesh/steps/adapt_test.cpp
  tests/unit/remesh/steps/apart_test.cpp
  tests/unit/remesh/steps/boundaries_test.cpp
  tests/unit/remesh/steps/delaunay_test.cpp
  tests/unit/remesh/steps/local_search_test.cpp
  tests/unit/remesh/steps/polish_test.cpp
  tests/unit/remesh/steps/relax_test.cpp
  tests/unit/remesh/steps/subdivide_test.cpp
  tests/unit/remesh/steps/sweeps_test.cpp
  tests/unit/remesh/steps/wanted_test.cpp
  tests/unit/remesh/symmetry/forced_planes_test.cpp
  tests/unit/remesh/symmetry/half_test.cpp
  tests/unit/remesh/symmetry/mirror_planes_test.cpp
  tests/unit/remesh/symmetry/mirrored_edges_test.cpp
  tests/unit/remesh/symmetry/mirrored_guides_test.cpp
  tests/unit/remesh/symmetry/mirroring_test.cpp
  tests/unit/remesh/transfer/chart_keeper_test.cpp
  tests/unit/remesher_test.cpp
  tests/unit/repair/body_mesh_test.cpp
  tests/unit/repair/body_union_test.cpp
  tests/unit/repair/boolean_test.cpp
  tests/unit/repair/fineness_test.cpp
  tests/unit/repair/holes/close_holes_test.cpp
  tests/unit/repair/holes/rims_test.cpp
  tests/unit/repair/loose_pieces_test.cpp
  tests/unit/repair/one_sided_test.cpp
  tests/unit/repair/pieces_test.cpp
  tests/unit/repair/repair_test.cpp
  tests/unit/repair/seen_share_test.cpp
  tests/unit/repair/sheet_bodies_test.cpp
  tests/unit/repair/sight_test.cpp
  tests/unit/repair/solid/cell_loops_test.cpp
  tests/unit/repair/solid/clean_up_test.cpp
  tests/unit/repair/solid/lattice_test.cpp
  tests/unit/repair/solid/seen_loss_test.cpp
  tests/unit/repair/solid/solid_test.cpp
  tests/unit/repair/solid/thin_walls_test.cpp
  tests/unit/repair/stitch_test.cpp
  tests/unit/repair/touching_faces_test.cpp
  tests/unit/simplify/boundary_places_test.cpp
  tests/unit/simplify/divide_test.cpp
  tests/unit/simplify/simplify_test.cpp
  tests/unit/simplify/slabs_test.cpp
  tests/unit/simplify/thin_out_test.cpp
  tests/unit/support/mesh_check.cpp
  tests/unit/textures/bake_onto_test.cpp
  tests/unit/textures/charts/atlas_figures_test.cpp
  tests/unit/textures/charts/chart_overlap_test.cpp
  tests/unit/textures/charts/chart_relaxing_test.cpp
  tests/unit/textures/charts/unwrap_test.cpp
  tests/unit/textures/new_texcoords_test.cpp
  tests/unit/textures/painting/cage_finder_test.cpp
  tests/unit/textures/painting/canvas_test.cpp
  tests/unit/textures/painting/corner_values_test.cpp
  tests/unit/textures/painting/line_search_test.cpp
  tests/unit/textures/painting/look_borders_test.cpp
  tests/unit/textures/painting/occlusion_test.cpp
  tests/unit/textures/painting/painter_test.cpp
  tests/unit/textures/painting/place_search_test.cpp
  tests/unit/textures/painting/side_finder_test.cpp
  tests/unit/textures/painting/tangents_test.cpp
  tests/unit/textures/painting/texture_test.cpp
  tests/unit/textures/repaint_test.cpp
)
target_include_directories(unit_tests PRIVATE tests/unit)
# Without a handler around each: a fourteenth less to compile.
target_compile_definitions(unit_tests PRIVATE DOCTEST_CONFIG_SUPER_FAST_ASSERTS)
# It includes doctest in another way.
set_source_files_properties(tests/unit/main.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON
  SKIP_UNITY_BUILD_INCLUSION ON)
if(REMESHER_PRECOMPILE)
  target_precompile_headers(unit_tests PRIVATE <Eigen/Core> <Eigen/Geometry> <algorithm>
    <doctest/doctest.h> <map> <memory> <optional> <random> <string> <vector>)
endif()
target_link_libraries(unit_tests PRIVATE core)
compile_rooms_as_one(unit_tests)

# What the benchmark and developers judge meshes with.
add_executable(measure tests/bench/measure_main.cpp)
target_link_libraries(measure PRIVATE core)

# What each step of the scheme `best` is worth: see tests/bench/ablation.js.
add_executable(ablation EXCLUDE_FROM_ALL tests/bench/ablation_main.cpp)
target_link_libraries(ablation PRIVATE core)

# How often each fallback and each limit of work fires: see tests/bench/fires.js.
add_executable(fires EXCLUDE_FROM_ALL tests/bench/fires_main.cpp)
target_link_libraries(fires PRIVATE core)

# What repair makes of a file, natively: see tests/bench/mended.js.
add_executable(mended EXCLUDE_FROM_ALL tests/bench/mended_main.cpp)
target_link_libraries(mended PRIVATE core)

# Random inputs for as long as wanted; not built by default.
add_executable(stress EXCLUDE_FROM_ALL tests/stress/stress_main.cpp)
target_include_directories(stress PRIVATE tests/unit)
target_link_libraries(stress PRIVATE core)

# What becomes of every kind of hostile mesh, as a table; not built by default.
add_executable(hostile EXCLUDE_FROM_ALL tests/stress/hostile_main.cpp)
target_include_directories(hostile PRIVATE tests/unit)
target_link_libraries(hostile PRIVATE core)

# What fuzzers run, without libFuzzer: files and changed copies of them.
set(fuzz_targets
  tests/fuzz/native/builder.cpp
  tests/fuzz/native/byte_changes.cpp
  tests/fuzz/native/glb.cpp
  tests/fuzz/native/gltf.cpp
  tests/fuzz/native/gltf_changes.cpp
  tests/fuzz/native/gmsh.cpp
  tests/fuzz/native/laws.cpp
  tests/fuzz/native/obj.cpp
  tests/fuzz/native/off.cpp
  tests/fuzz/native/ply.cpp
  tests/fuzz/native/reading.cpp
  tests/fuzz/native/remesh.cpp
  tests/fuzz/native/repair.cpp
  tests/fuzz/native/small_mesh.cpp
  tests/fuzz/native/stl.cpp
  tests/fuzz/native/targets.cpp
  tests/fuzz/native/threemf.cpp
  tests/fuzz/native/tree_changes.cpp
  tests/fuzz/native/vtu.cpp
  tests/unit/support/mesh_check.cpp
)
add_executable(fuzz_replay EXCLUDE_FROM_ALL ${fuzz_targets}
  tests/fuzz/native/replay.cpp
)
target_include_directories(fuzz_replay PRIVATE tests/unit)
target_link_libraries(fuzz_replay PRIVATE core)
compile_rooms_as_one(fuzz_replay)

if(REMESHER_FUZZ)
  add_executable(fuzz EXCLUDE_FROM_ALL ${fuzz_targets}
    tests/fuzz/native/libfuzzer.cpp
  )
  target_include_directories(fuzz PRIVATE tests/unit)
  target_link_libraries(fuzz PRIVATE core)
  target_link_options(fuzz PRIVATE -fsanitize=fuzzer)
  compile_rooms_as_one(fuzz)
endif()
