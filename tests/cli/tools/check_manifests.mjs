// Holds the manifests for Kubernetes against the schemas of its API, and what docker/compose.yaml says to workers against what it
// says to servers: with other limits workers are given nothing.
//
//   node check_manifests.mjs ROOT
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { Deployment } from "kubernetes-models/apps/v1/Deployment";
import { Job } from "kubernetes-models/batch/v1/Job";
import { parse, parseAllDocuments } from "yaml";

const root = process.argv[2];
const kinds = { Deployment, Job };
const wrong = [];

/** Why Kubernetes would not take a document; empty when it would. */
function fault(document) {
  const Kind = kinds[document.kind];
  if (!Kind) return `there is no schema of the kind '${document.kind}' here`;
  try {
    new Kind(document).validate();
    return "";
  } catch (error) {
    return error.message;
  }
}

const folder = join(root, "docker/kubernetes");
let seen = 0;
for (const name of readdirSync(folder)) {
  for (const document of parseAllDocuments(readFileSync(join(folder, name), "utf8"))) {
    ++seen;
    const manifest = document.toJS();
    const why = fault(manifest);
    if (why) wrong.push(`${name}: ${why}`);
    // What the check is worth: it sees a word that is wrong.
    if (!fault({ ...manifest, spec: { ...manifest.spec, template: { spec: { containers: "none" } } } })) wrong.push(`${name}: a broken copy is taken`);
  }
}
if (seen < 2) wrong.push(`only ${seen} manifests were found`);

const { services } = parse(readFileSync(join(root, "docker/compose.yaml"), "utf8"), { merge: true });
const decides = (name) => name === "DINI_QUEUE" || name === "DINI_REQUEST_BYTES";
for (const server of ["keeper", "evaluator"]) {
  for (const name of Object.keys(services[server].environment).filter(decides)) {
    if (services[server].environment[name] !== services.worker.environment[name]) wrong.push(`compose.yaml: ${name} of ${server} is not that of worker`);
  }
}
for (const line of wrong) console.error(line);
process.exit(wrong.length === 0 ? 0 : 1);
