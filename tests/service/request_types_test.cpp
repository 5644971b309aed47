#include <catch2/catch.hpp>

#include "service/requests/request_type.h"
#include "service/requests/requests.h"
#include "tests/service/finish.h"

using namespace dini;
using namespace dini::support;

namespace {

const std::unique_ptr<Engine> engine = make_engine();

struct Order {
  std::string item;
  std::optional<std::int64_t> count = {};
  Coating finish = Coating::shiny;
  bool wrapped = false;
  std::vector<std::string> notes = {};
  Json extras = Json::object();
};

const RequestType<Order>& order() {
  static const auto declared =
      RequestType<Order>("Order", "What is ordered.")
          .member("item", &Order::item, "The thing.", needed().example("vase"))
          .member("count", &Order::count, "How many.", left_out_means("one").range(1, 10).unit("pieces"))
          .member("finish", &Order::finish, "How it looks.", usually("shiny"))
          .member("wrapped", &Order::wrapped, "Whether it is wrapped.", usually(false))
          .member("notes", &Order::notes, "What to write on it.", left_out_means("nothing"))
          .member("extras", &Order::extras, "Anything else.", left_out_means("nothing"));
  return declared;
}

/// The only problem of a body.
Problem only_problem(const Json& body) {
  const auto read = order().read(body, *engine);
  REQUIRE_FALSE(read);
  REQUIRE(read.problems().size() == 1);
  return read.problems().front();
}

}  // namespace

TEST_CASE("A body is read into the members that it names, and the others keep their defaults") {
  const auto full = order().read(
      Json::parse(
          R"({"item": "cup", "count": 3.0, "finish": "plain", "wrapped": true, "notes": ["a", "b"], "extras": {"x": 1}})"),
      *engine);
  REQUIRE(full);
  CHECK(full->item == "cup");
  CHECK(full->count == 3);
  CHECK(full->finish == Coating::plain);
  CHECK(full->wrapped);
  CHECK(full->notes == std::vector<std::string>{"a", "b"});
  CHECK(full->extras == Json{{"x", 1}});
  const auto least = order().read({{"item", "cup"}}, *engine);
  REQUIRE(least);
  CHECK_FALSE(least->count);
  CHECK(least->finish == Coating::shiny);
  CHECK(least->extras == Json::object());
}

TEST_CASE("Every member says what is wrong with it, in one answer") {
  const auto read = order().read(
      Json::parse(R"({"itm": 1, "count": 1.5, "finish": 2, "wrapped": "yes", "notes": ["a", 1], "extras": []})"),
      *engine);
  REQUIRE_FALSE(read);
  std::map<std::string, std::string> codes;
  for (const Problem& problem : read.problems()) codes[problem.pointer.value()] = problem.code;
  CHECK(codes == std::map<std::string, std::string>{{"/itm", "unknown-member"},
                                                    {"/item", "required-input-missing"},
                                                    {"/count", "type-mismatch"},
                                                    {"/finish", "type-mismatch"},
                                                    {"/wrapped", "type-mismatch"},
                                                    {"/notes", "type-mismatch"},
                                                    {"/extras", "type-mismatch"}});
}

TEST_CASE("An unknown member is answered with the nearest one, and its name is escaped and shortened") {
  CHECK(only_problem({{"item", ""}, {"coutn", 1}}).detail.find("did you mean \"count\"?") != std::string::npos);
  CHECK(only_problem({{"item", ""}, {"a/b~c", 1}}).pointer == "/a~1b~0c");
  CHECK(only_problem({{"item", ""}, {std::string(63, 'x') + "\xc3\xa9", 1}}).pointer == "/" + std::string(63, 'x'));
}

TEST_CASE("A number out of range is answered with the range and the nearest number that fits") {
  const Problem low = only_problem({{"item", ""}, {"count", 0}});
  CHECK(low.code == "out-of-range");
  CHECK(low.detail == "'count' must be 1 to 10.");
  CHECK(low.fix == Json::parse(R"([{"op": "replace", "path": "/count", "value": 1}])"));
  CHECK(only_problem({{"item", ""}, {"count", 1e300}}).fix[0]["value"] == 10);
  CHECK(only_problem({{"item", ""}, {"count", -1e300}}).fix[0]["value"] == 1);
}

TEST_CASE("A word that is no choice is answered with the choices") {
  const Problem problem = only_problem({{"item", ""}, {"finish", "matt"}});
  CHECK(problem.code == "not-in-choices");
  CHECK(problem.detail == "'matt' is none of 'plain', 'shiny'.");
}

TEST_CASE("A body that is no object is told what it should hold") {
  for (const Json& body : {Json(nullptr), Json(1), Json::array(), Json("item")}) {
    CHECK(only_problem(body).detail.find("'item', 'count'") != std::string::npos);
  }
}

TEST_CASE("The schema of a request says what the reader enforces") {
  const Json schema = schema_of(order().description());
  CHECK(schema["required"] == Json::array({"item"}));
  CHECK(schema["additionalProperties"] == false);
  CHECK(schema["properties"]["count"]["minimum"] == 1);
  CHECK(schema["properties"]["count"]["maximum"] == 10);
  CHECK(schema["properties"]["finish"]["enum"] == Json::array({"plain", "shiny"}));
  CHECK(schema["properties"]["finish"]["default"] == "shiny");
  CHECK(schema["properties"]["notes"]["items"]["type"] == "string");
}

TEST_CASE("What the description of a request calls a default is what reading leaves in its place") {
  const auto evaluate = read_evaluate_body({{"graph", Json::object()}}, *engine);
  REQUIRE(evaluate);
  const RequestDescription& description = evaluate_description();
  CHECK(description.find("quality")->spec.default_value == "final");
  CHECK(evaluate->quality == Quality::final);
  CHECK(description.find("parts")->spec.default_value == evaluate->parts);
  CHECK(description.find("draco")->spec.default_value == evaluate->draco);
  CHECK(description.find("embed_graph")->spec.default_value == evaluate->embed_graph);
  CHECK(description.find("triangle_budget")->spec.default_value == Detail(Quality::draft).triangle_budget);
  const auto inspect = read_inspect_body({{"graph", Json::object()}, {"node", "a"}}, *engine);
  REQUIRE(inspect);
  CHECK(inspect_description().find("full")->spec.default_value == inspect->full);
}

TEST_CASE("The example of every request can be read, and every member says what it is in one sentence") {
  CHECK(read_evaluate_body(example_of(evaluate_description()), *engine));
  CHECK(read_inspect_body(example_of(inspect_description()), *engine));
  const auto sweep = read_sweep_body(example_of(sweep_description()), *engine);
  REQUIRE(sweep);
  CHECK(Variants::read(*sweep, sweep->parameters, 100));
  CHECK(read_validate_body(example_of(validate_description()), *engine));
  for (const RequestDescription* request :
       {&evaluate_description(), &inspect_description(), &sweep_description(), &validate_description()}) {
    for (const Member& member : request->members) {
      CAPTURE(request->name, member.name);
      CHECK(member.doc.ends_with('.'));
      const bool says_what_is_missing =
          member.spec.is_required || !member.spec.default_value.is_null() || !member.spec.when_missing.empty();
      CHECK(says_what_is_missing);
      if (!member.spec.example_value.is_null()) CHECK_FALSE(fault_in(member, member.spec.example_value));
      if (!member.spec.default_value.is_null()) CHECK_FALSE(fault_in(member, member.spec.default_value));
    }
  }
}
