#pragma once

#include "server/application.h"
#include "server/operation.h"

namespace dini::server {

// Each handler and what is told of it; routes.cpp has their methods and addresses.

/// The process answers.
Reply health(const Context& context);
Operation describe_health();
/// Whether to send requests here, and the numbers of the server.
Reply ready(const Context& context);
Operation describe_ready();
Reply metrics(const Context& context);
Operation describe_metrics();
/// The engine and every limit by name.
Reply version(const Context& context);
Operation describe_version();
/// The description of all routes, as OpenAPI.
Reply openapi(const Context& context);
Operation describe_openapi();
/// The same to read, and its style.
Reply docs(const Context& context);
Operation describe_docs();
Reply docs_style(const Context& context);
Operation describe_docs_style();
/// What a code means, to read.
Reply problem_page(const Context& context);
Operation describe_problem_page();
/// The catalogue.
Reply nodes(const Context& context);
Operation describe_nodes();
/// The JSON Schema of the graph document.
Reply schema(const Context& context);
Operation describe_schema();
/// The built-in graphs: the list, one of them, and its picture.
Reply example_list(const Context& context);
Operation describe_example_list();
Reply example(const Context& context);
Operation describe_example();
Reply example_picture(const Context& context);
Operation describe_example_picture();
/// Everything that is wrong, without evaluating.
Reply validate(const Context& context);
Operation describe_validate();
/// The value on one wire.
void inspect(const Context& context);
Operation describe_inspect();
/// What an evaluation would do.
Reply explain(const Context& context);
Operation describe_explain();
/// The model, the report, or both.
void evaluate(const Context& context);
Operation describe_evaluate();
/// How values change with parameters.
void gradient(const Context& context);
Operation describe_gradient();
/// Parameters found by what is to come of them, as a job.
void create_fit(const Context& context);
Operation describe_create_fit();
/// Many settings of the parameters of a graph.
void sweep(const Context& context);
Operation describe_sweep();
/// Graphs that are kept: the list, one of them, its versions and what differs between two, how it looks from outside,
/// and the model of an output.
Reply graph_list(const Context& context);
Operation describe_graph_list();
Reply get_graph(const Context& context);
Operation describe_get_graph();
Reply put_graph(const Context& context);
Operation describe_put_graph();
Reply delete_graph(const Context& context);
Operation describe_delete_graph();
Reply graph_versions(const Context& context);
Operation describe_graph_versions();
Reply graph_difference(const Context& context);
Operation describe_graph_difference();
Reply graph_interface(const Context& context);
Operation describe_graph_interface();
void graph_output(const Context& context);
Operation describe_graph_output();
/// Long work: begun, asked about, followed, stopped, and what came of it.
void create_job(const Context& context);
Operation describe_create_job();
Reply get_job(const Context& context);
Operation describe_get_job();
Reply job_events(const Context& context);
Operation describe_job_events();
Reply cancel_job(const Context& context);
Operation describe_cancel_job();
Reply job_result(const Context& context);
Operation describe_job_result();
/// A file that was made.
Reply artifact(const Context& context);
Operation describe_artifact();
/// A mesh file for `import`: taken, and given back.
void add_asset(const Context& context);
Operation describe_add_asset();
Reply asset(const Context& context);
Operation describe_asset();
/// The page: `/` and every file of it, which has no route of its own.
Reply page_file(const Context& context);
Operation describe_page();
/// The page that shows one stored graph in a frame of another page.
Reply embed_page(const Context& context);
Operation describe_embed_page();

/// A body from outside as JSON; the media type must say so, which also keeps foreign web forms out.
Result<Json> read_json(const Context& context);

}  // namespace dini::server
