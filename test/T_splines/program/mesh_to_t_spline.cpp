// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Cube_map.h"
#include "Program_test.h"

#include <CGAL/T_splines/IO/read_map_obj.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/T_mesh/check_spline_compatibility.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace mesh_to_t_spline_test {

namespace {

/// Checks that the triangles are a closed surface with the Euler characteristic, and the normals have length 1.
void check_tessellation(const std::string& file, const long euler_characteristic)
{
  Mesh mesh;
  REQUIRE(CGAL::T_splines::read_triangle_mesh(file, mesh).success());
  CHECK(CGAL::is_closed(mesh));
  CHECK(static_cast<long>(mesh.number_of_vertices()) - static_cast<long>(mesh.number_of_edges()) +
            static_cast<long>(mesh.number_of_faces()) ==
        euler_characteristic);
}

/// Checks that a run's directory holds the six files and nothing else, that the map refines the mesh, and that the
/// T-mesh and the tessellation have the same topology.
void check_output(const std::string& directory, const std::string& mesh_file)
{
  CHECK(files_of(directory) ==
        std::set<std::string>{"map.obj", "report.html", "report.json", "t_mesh.ply", "t_spline.obj", "t_spline.vtu"});
  CHECK(contains(file_content(directory + "/report.json"), "\"converged\": true"));
  CHECK(contains(file_content(directory + "/report.json"), "\"status\": \"the map is exactly seamless\""));
  CHECK(contains(file_content(directory + "/report.html"), "</html>"));

  Mesh input, refined;
  REQUIRE(CGAL::T_splines::read_triangle_mesh(mesh_file, input).success());
  const auto uv = refined.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  REQUIRE(CGAL::T_splines::read_map_obj(directory + "/map.obj", refined, uv).success());
  REQUIRE(refined.number_of_vertices() >= input.number_of_vertices());
  CHECK(refined.number_of_vertices() - refined.number_of_edges() + refined.number_of_faces() ==
        input.number_of_vertices() - input.number_of_edges() + input.number_of_faces());
  bool are_points_equal = true, are_triangles_positive = true;
  for (const Mesh::Vertex_index v : input.vertices())
    are_points_equal = are_points_equal && input.point(v) == refined.point(v);
  for (const Mesh::Face_index f : refined.faces()) {
    const auto h = refined.halfedge(f);
    are_triangles_positive = are_triangles_positive && CGAL::left_turn(uv[h], uv[refined.next(h)], uv[refined.prev(h)]);
  }
  CHECK(are_points_equal);
  CHECK(are_triangles_positive);
  Test_t_mesh t_mesh;
  REQUIRE(t_mesh.read(directory + "/t_mesh.ply").success());
  const long characteristic = static_cast<long>(input.number_of_vertices()) -
                              static_cast<long>(input.number_of_edges()) + static_cast<long>(input.number_of_faces());
  CHECK(t_mesh.euler_characteristic() == characteristic);
  CHECK(CGAL::T_splines::check_spline_compatibility(t_mesh).success());
  check_tessellation(directory + "/t_spline.obj", characteristic);
  const std::string patches = file_content(directory + "/t_spline.vtu");
  CHECK(contains(patches, "<PointData RationalWeights=\"RationalWeights\">"));
  CHECK(contains(patches, "</VTKFile>"));
}

} // namespace

TEST_CASE("README and manual list the options as the program does, and README has the first example as it is")
{
  const std::string readme = file_content(T_SPLINES_SOURCE_DIR "/README.md"),
                    manual = file_content(T_SPLINES_SOURCE_DIR "/doc/T_splines/T_splines.txt"),
                    example = file_content(T_SPLINES_SOURCE_DIR "/examples/T_splines/first_surface.cpp");
  const Program_run table("--help=markdown"), help("--help");
  REQUIRE(table.exit_code == 0);
  std::istringstream rows(table.output);
  int number = 0;
  for (std::string row; std::getline(rows, row); ++number) {
    INFO(row);
    CHECK(contains(readme, row + "\n"));
    CHECK(contains(manual, row + "\n"));
    const std::size_t name = row.find("`--");
    if (name != std::string::npos)
      CHECK(contains(help.output, "  " + row.substr(name + 1, row.find_first_of(" `", name + 1) - name - 1)));
  }
  CHECK(number > 25);
  CHECK(contains(readme, "```cpp\n" + example.substr(example.find("#include")) + "```\n"));
}

TEST_CASE("help and version")
{
  const Program_run help("--help"), version("--version");
  CHECK(help.exit_code == 0);
  CHECK(contains(help.output, "Usage: mesh_to_t_spline MESH"));
  CHECK_FALSE(contains(help.output, "@"));
  CHECK(version.exit_code == 0);
  CHECK(contains(version.output, "mesh_to_t_spline 0."));
}

TEST_CASE("bad usage is refused with exit code 2")
{
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "no mesh"},
      {"a.off b.off", "more than one mesh"},
      {"a.off --colour", "unknown option --colour"},
      {"a.off --solver lu", "--solver needs one of ldlt, cholmod"},
      {"a.off --flips", "--flips needs a value"},
      {"a.off --quiet=yes", "--quiet takes no value"},
      {"a.off --max-iterations 0", "--max-iterations needs an integer of at least 1"},
      {"a.off --tolerance-residual=nan", "--tolerance-residual needs a positive number"},
      {"a.off --cones a.cones --loops 1,x", "--loops needs integers separated by commas"},
      {"a.off --loops 1,2", "--loops goes with --cones"},
      {"a.off --merge", "--merge needs a value"},
      {"a.off --merge=-1", "--merge needs a number that is not negative"},
      {"a.off --merge nan", "--merge needs a number that is not negative"},
      {"a.off --no-merge=1", "--no-merge takes no value"},
      {"a.off --no-merge --merge 1e-5", "--no-merge and --merge exclude each other"},
      {"a.off --repair --no-merge", "--no-merge and --repair exclude each other"},
      {"--uv a.obj --repair", "--repair does not go with --uv"},
      {"a.off --field a.rawfield --cones a.cones", "--field and --cones exclude each other"},
      {"a.off --field a.rawfield --align-curvature 1", "--align-curvature is for the computed field"},
      {"--uv a.obj b.off", "--uv and a mesh exclude each other"},
      {"--uv a.obj --map-only", "--uv and --map-only leave nothing to do"},
      {"--uv a.obj --precision quad", "--precision does not go with --uv"},
      {"--uv a.obj --cones a.cones", "--cones does not go with --uv"},
      {"--uv", "--uv needs a value"},
      {"a.off --no-regularization=1", "--no-regularization takes no value"},
      {"a.off --tolerance 0", "--tolerance needs a positive number"},
      {"a.off --tolerance nan", "--tolerance needs a positive number"},
      {"a.off --tolerance=-0.1", "--tolerance needs a positive number"},
      {"a.off --tolerance inf", "--tolerance needs a positive number"},
      {"a.off --tolerance 1%", "--tolerance needs a positive number"},
      {"a.off --max-control-points 0", "--max-control-points needs an integer of at least 1"},
      {"a.off --max-control-points 1e3", "--max-control-points needs an integer of at least 1"},
      {"a.off --fairness=-1", "--fairness needs a number that is not negative"},
      {"a.off --fairness nan", "--fairness needs a number that is not negative"},
      {"a.off --levels=3", "--levels takes no value"},
      {"a.off --max-cones=-1", "--max-cones needs an integer of at least 0"},
      {"a.off --cone-energy=-1", "--cone-energy needs a number that is not negative"},
      {"a.off --all-cones --max-cones 3", "--all-cones and --max-cones exclude each other"},
      {"a.off --all-cones --cone-energy 3", "--all-cones and --cone-energy exclude each other"},
      {"a.off --cones a.cones --max-cones 3", "--max-cones is for the computed field"},
      {"a.off --field a.rawfield --all-cones", "--all-cones is for the computed field"},
      {"--uv a.obj --max-cones 3", "--max-cones does not go with --uv"},
      {"a.off --no-spline --tolerance 0.1", "--tolerance goes with a T-spline"},
      {"a.off --map-only --levels", "--levels goes with a T-spline"},
      {"a.off --resolution 1", "--resolution needs an integer of at least 2"},
      {"a.off --map-only --fairness 0.1", "--fairness goes with a T-spline"},
      {"a.off --no-spline --resolution 4", "--resolution goes with a T-spline"}};
  for (const auto& [arguments, message] : cases) {
    const Program_run run(arguments);
    CAPTURE(arguments, run.errors);
    CHECK(run.exit_code == 2);
    CHECK(contains(run.errors, message));
    CHECK(run.output.empty());
  }
  const Temporary_directory directory;
  std::ofstream(directory.file("file")) << "x";
  const Program_run run(tetrahedron + " -o '" + directory.file("file/output") + "'");
  CHECK(run.exit_code == 2);
  CHECK(contains(run.errors, "is not a directory"));
}

TEST_CASE("every bad mesh file is refused with its name, exit code 2, and nothing is written")
{
  for (const auto& entry : std::filesystem::directory_iterator(data + "bad_meshes")) {
    Mesh mesh;
    const auto report = CGAL::T_splines::read_triangle_mesh(entry.path().string(), mesh);
    const Program_run run = failing_run("'" + entry.path().string() + "'");
    CAPTURE(entry.path(), run.errors);
    CHECK(run.exit_code == 2);
    CHECK(contains(run.errors, entry.path().string() + ": " + describe(report)));
  }
  CHECK(failing_run("no_such_file.off").exit_code == 2);
}

TEST_CASE("every bad cone or field file is refused with its name, exit code 2, and nothing is written")
{
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"gauss_bonnet.cones", "is 2 instead of 8 (off by -6)"},
      {"duplicate.cones", "line 3: a vertex is listed twice (vertex 0"},
      {"out_of_range.cones", "line 2: an index is out of range: the mesh has no such vertex (vertex 4"},
      {"negative_index.cones", "line 2: an index is out of range: the mesh has no such vertex (vertex -1"},
      {"zero.cones", "vertex 0, counted from 0, has k = 0"},
      {"negative.cones", "vertex 1, counted from 0, has k = -2"},
      {"truncated.cones", "truncated"},
      {"word.cones", "line 2: the file does not follow its format here"},
      {"wrong_count.Th_hat", "3 instead of 4"},
      {"no_quarter_turn.Th_hat", "not a multiple of a quarter turn (vertex 2"},
      {"no_such_file.cones", "the file cannot be read"},
      {"cones.txt", "the file format is not known"},
      {"wrong_count.rawfield", "3 instead of 4"},
      {"truncated.rawfield", "truncated"},
      {"two_directions.rawfield", "2 instead of 4"},
      {"zero_vector.rawfield", "a vector is zero (face 2"},
      {"not_tangent.rawfield", "not tangent to its face (face 2"},
      {"nan.rawfield", "a number is not finite (element 1"},
      {"no_such_file.rosy", "the file cannot be read"},
      {"field.txt", "the file format is not known"}};
  std::set<std::string> known;
  for (const auto& [name, message] : cases) {
    known.insert(name);
    const bool is_field = contains(name, "field") || contains(name, "rosy");
    const std::string file = data + "bad_guidance/" + name;
    const Program_run run = failing_run(tetrahedron + (is_field ? " --field '" : " --cones '") + file + "'");
    CAPTURE(name, run.errors);
    CHECK(run.exit_code == 2);
    CHECK(contains(run.errors, file + ": "));
    CHECK(contains(run.errors, message));
  }
  for (const auto& entry : std::filesystem::directory_iterator(data + "bad_guidance"))
    CHECK(known.count(entry.path().filename().string()) == 1);
}

TEST_CASE("turning numbers must be as many as loops")
{
  const Temporary_directory directory;
  write_torus(directory.file("torus.obj"), 10, 0, 1);
  std::ofstream(directory.file("none.cones"));
  const std::string arguments =
      "'" + directory.file("torus.obj") + "' --cones '" + directory.file("none.cones") + "' --loops ";
  const Program_run run = failing_run(arguments + "1");
  CHECK(run.exit_code == 2);
  CHECK(contains(run.errors, "is 1 instead of 2"));
  const Program_run good(arguments + "0,0 -o '" + directory.file("output") + "'");
  CAPTURE(good.errors);
  CHECK(good.exit_code == 0);
  check_output(directory.file("output"), directory.file("torus.obj"));
}

TEST_CASE("a computation that does not end well has exit code 1 and writes nothing")
{
  const Temporary_directory directory;
  write_torus(directory.file("torus.obj"), 20, 0, 1);
  const Program_run run = failing_run("'" + directory.file("torus.obj") + "' --max-iterations 1");
  CHECK(run.exit_code == 1);
  CHECK(contains(run.errors, "the iteration limit was reached"));
}

TEST_CASE("a disk that is full leaves nothing behind")
{
  const Temporary_directory directory;
  std::filesystem::create_directory(directory.file("output"));
  std::ofstream(directory.file("output/map.obj")) << "old";
  const std::string cube = data + "good_meshes/cube.obj";
  const Program_run run("'" + cube + "' --levels -o '" + directory.file("output") + "'", "ulimit -f 4;");
  CAPTURE(run.errors);
  CHECK(run.exit_code == 1);
  CHECK(contains(run.errors, "cannot write " + directory.file("output")));
  CHECK(file_content(directory.file("output/map.obj")) == "old");
  CHECK(files_of(directory.file("output")) == std::set<std::string>{"map.obj"});
}

TEST_CASE("an interrupted run has exit code 130 and leaves nothing behind")
{
  const Temporary_directory directory;
  write_torus(directory.file("torus.obj"), 150, 0, 1);
  // In the background, timeout would signal twice, and the second signal ends the program at once.
  const Program_run run =
      failing_run("'" + directory.file("torus.obj") + "'", "timeout --foreground --signal=INT --preserve-status 0.5");
  CAPTURE(run.errors);
  CHECK(run.exit_code == 130);
}

TEST_CASE("a good mesh gives the map, the T-mesh and the report")
{
  const Temporary_directory directory;
  const std::string cube = data + "good_meshes/cube.obj", output = directory.file("a/b");
  const Program_run run("'" + cube + "' -o '" + output + "'");
  CAPTURE(run.errors);
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.errors, "note: 6 of 6 faces are not triangles"));
  CHECK(contains(run.output, "8 vertices, 12 faces, genus 0"));
  CHECK(contains(run.output, "converged"));
  CHECK(contains(run.output,
                 "map.obj, t_mesh.ply, t_spline.vtu, t_spline.obj, report.json and report.html in " + output));
  check_output(output, cube);

  // The page is self-contained: it names no other place. (The name space of SVG is a name.)
  std::string page = file_content(output + "/report.html");
  const std::string svg = "http://www.w3.org/2000/svg";
  REQUIRE(contains(page, svg));
  page.erase(page.find(svg), svg.size());
  for (const char* part : {"http:", "https:", "src=", "@import", "fetch("})
    CHECK_FALSE(contains(page, part));

  const Program_run quiet("'" + cube + "' --quiet -o '" + output + "'");
  CHECK(quiet.exit_code == 0);
  CHECK(quiet.output.empty());
  CHECK(quiet.errors.empty());
  check_output(output, cube);
}

TEST_CASE("the option --map-only ends with the map")
{
  const Temporary_directory directory;
  const std::string output = directory.file("output");
  const Program_run run("'" + data + "good_meshes/cube.obj' --map-only -o '" + output + "'");
  CAPTURE(run.errors);
  REQUIRE(run.exit_code == 0);
  CHECK(files_of(output) == std::set<std::string>{"map.obj", "report.html", "report.json"});
  CHECK_FALSE(contains(file_content(output + "/report.json"), "\"t_mesh\""));
}

TEST_CASE("a given map gives the T-mesh and the report")
{
  const Temporary_directory directory;
  const std::string output = directory.file("output");
  Cube_map(2).write(directory.file("cube.obj"));
  for (const char* option : {"", "--no-regularization"}) {
    const Program_run run("--uv '" + directory.file("cube.obj") + "' --no-spline " + option + " -o '" + output + "'");
    CAPTURE(run.errors, option);
    REQUIRE(run.exit_code == 0);
    CHECK(files_of(output) == std::set<std::string>{"report.html", "report.json", "t_mesh.ply"});
    CHECK(contains(run.output, "8 cones (k = 3: 8)"));
    CHECK(contains(run.output, "all scale factors are 1"));
    const std::string report = file_content(output + "/report.json");
    CHECK_FALSE(contains(report, "\"map\""));
    CHECK(contains(report, "\"regularized\"") == std::string(option).empty());
    CHECK_FALSE(contains(report, "\"t_spline\""));

    // The T-mesh is the cube.
    Test_t_mesh t_mesh;
    REQUIRE(t_mesh.read(output + "/t_mesh.ply").success());
    CHECK(t_mesh.graph().number_of_faces() == 6);
    CHECK(t_mesh.graph().number_of_edges() == 12);
    for (const auto h : t_mesh.graph().halfedges()) {
      CHECK(t_mesh.corners()[h]);
      CHECK(t_mesh.knots()[h] == 1);
    }
    for (const auto v : t_mesh.graph().vertices())
      for (int d = 0; d < 3; ++d)
        CHECK((t_mesh.graph().point(v)[d] == 0 || t_mesh.graph().point(v)[d] == 1));
  }
}

TEST_CASE("a given map may have a border")
{
  const Temporary_directory directory;
  Cube_map box(1);
  box.corners.resize(box.corners.size() - 6); // without its lid
  box.write(directory.file("box.obj"));
  const std::string arguments = "--uv '" + directory.file("box.obj") + "' -o '" + directory.file("output") + "'";
  const Program_run run(arguments + " --no-spline");
  CAPTURE(run.errors);
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.output, "8 vertices, 10 faces, genus 0"));
  CHECK(contains(run.output, "4 cones (k = 3: 4)"));
  Test_t_mesh t_mesh;
  REQUIRE(t_mesh.read(directory.file("output/t_mesh.ply")).success());
  CHECK(t_mesh.graph().number_of_faces() == 5);
  CHECK(t_mesh.euler_characteristic() == 1);

  // The border of the surface is close to that of the box, which lies in the plane of the missing lid.
  const Program_run with_spline(arguments);
  CAPTURE(with_spline.errors);
  REQUIRE(with_spline.exit_code == 0);
  Mesh triangles;
  REQUIRE(CGAL::IO::read_polygon_mesh(directory.file("output/t_spline.obj"), triangles));
  CGAL::Bbox_3 box_of_border;
  for (const auto v : triangles.vertices())
    if (triangles.is_border(v))
      box_of_border += triangles.point(v).bbox();
  CHECK(std::min({box_of_border.x_span(), box_of_border.y_span(), box_of_border.z_span()}) < 0.02);
  CHECK(std::max({box_of_border.x_span(), box_of_border.y_span(), box_of_border.z_span()}) > 0.5);
}

TEST_CASE("every kind of bad map is refused with its name and element, exit code 2, and nothing is written")
{
  using Edit = void (*)(Cube_map&);
  const std::vector<std::pair<Edit, std::string>> cases = {
      {[](Cube_map& map) { map.uv_is_missing = true; }, "a corner has no texture coordinates"},
      {[](Cube_map& map) { map.corners[17].has_uv = false; }, "a corner has no texture coordinates (vertex 2, face 5"},
      {[](Cube_map& map) { map.corners[4].u = NAN; }, "a coordinate is not a finite number: found \"nan\""},
      {[](Cube_map& map) {
         std::swap(map.corners[9].u, map.corners[10].u), std::swap(map.corners[9].v, map.corners[10].v);
       },
       "not positively oriented: 1 face, 3;"},
      {[](Cube_map& map) { map.corners[9].u = map.corners[10].u, map.corners[9].v = map.corners[10].v; },
       "triangles of area zero: 1 face, 3;"},
      {[](Cube_map& map) { map.change_chart(2, [](double& u, double& v) { u += 0.3 * v; }); },
       "the angle around a vertex is no multiple of a right angle: vertex "},
      {[](Cube_map& map) {
         map.change_chart(2, [](double& u, double& v) {
           const double w = u;
           u = 0.6 * u - 0.8 * v, v = 0.8 * w + 0.6 * v;
         });
       },
       "the rotation across a seam is no multiple of a right angle: edge from vertex "},
      {[](Cube_map& map) { map.change_chart(2, [](double& u, double&) { u = u == 0.5 ? 0.625 : u; }); },
       "the transition across a seam is no similarity: edge from vertex "},
      {[](Cube_map& map) { map.change_chart(2, [](double& u, double&) { u *= 2; }); },
       "the scale factors around a vertex do not multiply to one: vertex "},
      {[](Cube_map& map) { map.corners.resize(map.corners.size() - 3); },
       "a border edge is not parallel to an axis: edge "}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Temporary_directory directory;
    const std::string file = directory.file("map.obj");
    Cube_map map(2);
    cases[i].first(map);
    map.write(file);
    const Program_run run = failing_run("--uv '" + file + "'");
    CAPTURE(i, run.errors);
    CHECK(run.exit_code == 2);
    CHECK(contains(run.errors, file + ": "));
    CHECK(contains(run.errors, cases[i].second));
  }
  CHECK(failing_run("--uv no_such_file.obj").exit_code == 2);
  CHECK(contains(failing_run("--uv '" + tetrahedron + "'").errors, "the file format is not known"));
}

TEST_CASE("the page draws in a browser, where there is one")
{
  const Temporary_directory directory;
  const std::string output = directory.file("output");
  REQUIRE(Program_run("'" + data + "good_meshes/cube.obj' -o '" + output + "'").exit_code == 0);
  const std::optional<std::string> drawn = page_in_browser(output, "view=deviation&place=worst&compare=0.25");
  if (!drawn) {
    WARN("no chromium that runs: the page was not tried");
    return;
  }
  const std::string& page = *drawn;
  CHECK(contains(page, "<title>cube.obj: T-spline surface</title>"));
  const std::string report = file_content(output + "/report.json");
  std::smatch verdict;
  REQUIRE(std::regex_search(report, verdict, std::regex("\"verdict\": \"([^\"]*)\"")));
  const bool is_faultless = contains(report, "\"is_faultless\": true");
  CHECK(contains(page, std::string("<span class=\"") + (is_faultless ? "good" : "bad") + "\">the surface is " +
                           verdict[1].str() + "</span>"));
  CHECK(contains(page, "<div id=\"place_mark\" aria-hidden=\"true\" style=\"left: "));
  CHECK(contains(page, "data-place=\"worst\""));
  CHECK(contains(page, "aria-checked=\"true\">Deviation</button>"));
  CHECK(contains(page, "distance from the mesh, by the longest side of its bounding box"));
  CHECK(contains(page, "aria-valuenow=\"25\""));
  CHECK(contains(page, "aria-label=\"Errors against the number of control points\""));
  CHECK(contains(page, "aspect ratio, worst"));
  for (const char* name : {"none", "as traced", "regularized"})
    CHECK(contains(page, "type=\"button\" aria-checked=\"" +
                             std::string(name == std::string("regularized") ? "true" : "false") + "\">" + name +
                             "</button>"));
  CHECK(contains(page, "k = 3, angle 270"));
  CHECK_FALSE(contains(page, "<h2>Free edge</h2>"));
  CHECK(contains(page, "<p id=\"message\" hidden=\"\"></p>")); // where it says why it cannot draw
  CHECK(contains(page, "aria-checked=\"true\""));              // the last thing that is set up
}

TEST_CASE("solvers, flip policies and number types")
{
  const Temporary_directory directory;
  const std::string mesh = directory.file("torus.obj"), output = directory.file("output");
  write_torus(mesh, 10, 0, 1);
  for (const char* option :
       {"--flips degeneracy", "--flips degeneracy-only", "--precision extended", "--precision quad"}) {
    const Program_run run("'" + mesh + "' " + option + " -o '" + output + "'");
    CAPTURE(option, run.errors);
    CHECK(run.exit_code == 0);
    check_output(output, mesh);
  }
  const Program_run cholmod("'" + mesh + "' --solver cholmod -o '" + output + "'");
  CHECK((cholmod.exit_code == 0 || contains(cholmod.errors, "built without CHOLMOD")));
}

TEST_CASE("a far offset and a tiny scale make no difference")
{
  for (const auto& [offset, scale] : {std::pair(1e7, 1.), std::pair(0., 1e-9), std::pair(0., 1e9)}) {
    const Temporary_directory directory;
    const std::string mesh = directory.file("torus.obj");
    write_torus(mesh, 20, offset, scale);
    const Program_run run("'" + mesh + "' -o '" + directory.file("output") + "'");
    CAPTURE(offset, scale, run.errors);
    REQUIRE(run.exit_code == 0);
    check_output(directory.file("output"), mesh);
  }
}

} // namespace mesh_to_t_spline_test
