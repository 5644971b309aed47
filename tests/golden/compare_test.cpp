// Models compared with golden results: what counts as the same, and what is said about what does not.

#include "golden/compare.h"

#include <catch2/catch.hpp>

#include "geometry/primitives.h"
#include "gltf/gltf_formats.h"
#include "golden/golden_result.h"

using namespace dini;

namespace {

struct Drawn {
  std::vector<Part> parts;

  Drawn& add(Mesh mesh) {
    parts.push_back(
        {.name = "part " + std::to_string(parts.size()), .shape = std::make_shared<const Mesh>(std::move(mesh))});
    return *this;
  }
};

Mesh ball(double radius, const Color& color = {0.5, 0.5, 0.5, 1}) {
  Mesh mesh = sphere_mesh({0, 0, 0}, radius, 48, 24, Cancel());
  mesh.color = color;
  return mesh;
}

Model model_of_parts(const Drawn& drawn, int position_bits = 14) {
  const auto written =
      glb_format().write({drawn.parts}, {.position_bits = position_bits, .about = Json::object()}, Cancel());
  REQUIRE(written);
  File file{"model/gltf-binary", ".glb", share(written->bytes), sha256(written->bytes)};
  file.position_error = written->position_error;
  auto model = model_of(file);
  REQUIRE(model);
  return *std::move(model);
}

Model model_of_mesh(Mesh mesh, int position_bits = 14) {
  return model_of_parts(Drawn().add(std::move(mesh)), position_bits);
}

/// As it is after a way through a file.
ModelFacts kept(const Model& model) {
  const auto read = read_golden(write_golden({.engine = "1", .graph = "2", .outputs = {{"out", model.facts}}}));
  REQUIRE(read);
  return read->outputs.at("out");
}

std::string said(const Comparison& comparison) {
  std::string text;
  for (const std::string& difference : comparison.differences) text += difference + "\n";
  return text;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

constexpr double tolerance = 1e-6;

}  // namespace

TEST_CASE("The facts of a sphere are those of a sphere") {
  const ModelFacts facts = model_of_mesh(ball(1)).facts;
  CHECK(facts.closed);
  CHECK(facts.euler == 2);
  CHECK(facts.area == Approx(12.566).epsilon(0.01));
  CHECK(facts.volume == Approx(4.189).epsilon(0.02));
  CHECK(facts.samples.size() == 256);
  CHECK(facts.spacing < 0.5);
  for (const Sample& sample : facts.samples) {
    CHECK(length(sample.position) == Approx(1).epsilon(0.02));
    CHECK(dot(sample.position, sample.normal) > 0.9);
  }
}

TEST_CASE("A golden result that was written is read as it was") {
  const Model model = model_of_mesh(ball(1));
  const ModelFacts read = kept(model);
  CHECK(read.sha256 == model.facts.sha256);
  CHECK(read.triangles == model.facts.triangles);
  CHECK(read.area == Approx(model.facts.area).epsilon(1e-8));
  REQUIRE(read.samples.size() == model.facts.samples.size());
  CHECK(length(read.samples[7].position - model.facts.samples[7].position) < 1e-6);
  CHECK(compare(read, model, tolerance).verdict == Comparison::Verdict::same);
}

TEST_CASE("The same shape rounded otherwise is within, and how far it is off is told") {
  const ModelFacts golden = kept(model_of_mesh(ball(1)));
  const int bits = GENERATE(11, 13, 16);
  const Comparison comparison = compare(golden, model_of_mesh(ball(1), bits), tolerance);
  CAPTURE(bits, said(comparison));
  CHECK(comparison.verdict == Comparison::Verdict::within);
  CHECK(comparison.deviation > 0);
  CHECK(comparison.deviation <= comparison.accepted);
}

TEST_CASE("Another size is changed, and is said with its place and measure") {
  const ModelFacts golden = kept(model_of_mesh(ball(1)));
  const Comparison comparison = compare(golden, model_of_mesh(ball(1.002)), tolerance);
  CHECK(comparison.verdict == Comparison::Verdict::changed);
  CHECK(has(said(comparison), "shape: ("));
  CHECK(has(said(comparison), "largest z: 1.00"));
  // A wider tolerance takes it.
  CHECK(compare(golden, model_of_mesh(ball(1.002)), 0.01).verdict == Comparison::Verdict::within);
}

TEST_CASE("What came and what went is found, however small its part in all measures") {
  Mesh small = sphere_mesh({3, 0, 0}, 0.01, 8, 4, Cancel());
  const Model with = model_of_parts(Drawn().add(ball(1)).add(small));
  const Model without = model_of_mesh(ball(1));
  CHECK(has(said(compare(kept(without), with, tolerance)), "is on the model and was not"));
  CHECK(has(said(compare(kept(with), without, tolerance)), "triangles: "));
}

TEST_CASE("Colors and the sides of triangles are compared where the shape is the same") {
  const ModelFacts golden = kept(model_of_mesh(ball(1)));
  const Comparison red = compare(golden, model_of_mesh(ball(1, {0.8, 0.5, 0.5, 1})), tolerance);
  CHECK(red.verdict == Comparison::Verdict::changed);
  CHECK(has(said(red), ": 0.8 0.5 0.5 1, was 0.5 0.5 0.5 1"));
  Mesh inside_out = ball(1);
  for (auto& triangle : inside_out.triangles.edit()) std::swap(triangle[0], triangle[1]);
  const std::string turned = said(compare(golden, model_of_mesh(inside_out), tolerance));
  CHECK(has(turned, "normals: 256 of 256 points face another way"));
  CHECK(has(turned, "volume: -"));
}

TEST_CASE("Two parts in another order are the same shape") {
  const Mesh other = sphere_mesh({3, 0, 0}, 0.5, 24, 12, Cancel());
  const ModelFacts golden = kept(model_of_parts(Drawn().add(ball(1)).add(other)));
  const Comparison comparison = compare(golden, model_of_parts(Drawn().add(other).add(ball(1))), tolerance);
  CAPTURE(said(comparison));
  CHECK(comparison.verdict == Comparison::Verdict::within);
}

TEST_CASE("Curves and points are compared too") {
  const auto drawn = [](double height) {
    Polyline line{.points = Column<Point>(3), .closed = true};
    line.points.set(1, {1, 0, 0});
    line.points.set(2, {0, 1, height});
    Column<Point> points(1);
    points.set(0, {2, 0, 0});
    Drawn all;
    all.parts.push_back({.name = "curve", .shape = std::vector<Polyline>{line}});
    all.parts.push_back({.name = "points", .shape = std::make_shared<const Column<Point>>(points)});
    return model_of_parts(all);
  };
  const ModelFacts golden = kept(drawn(0));
  CHECK(golden.segments == 3);
  CHECK(golden.points == 1);
  CHECK(golden.samples.size() == 65);
  CHECK(compare(golden, drawn(0), tolerance).verdict == Comparison::Verdict::same);
  CHECK(has(said(compare(golden, drawn(0.1), tolerance)), "shape: ("));
}

TEST_CASE("What is no golden result is refused with a sentence") {
  CHECK(read_golden("{").problems().front().code == "not-json");
  CHECK(read_golden("{}").problems().front().detail == "this is no golden result");
  CHECK(has(read_golden(R"({"golden": 2})").problems().front().detail, "format 2"));
  CHECK(has(read_golden(R"({"golden": 1, "engine": 3})").problems().front().detail, "--update-golden"));
}
