#include "server/docs_page.h"

namespace dini::server {

std::string_view docs_style_sheet() {
  return R"(:root {
  color-scheme: light dark;
  --ground: #ffffff;
  --raised: #f4f5f7;
  --line: #dcdfe4;
  --text: #1c2026;
  --quiet: #59616d;
  --accent: #2456c4;
  --get: #17693c;
  --post: #8a4b00;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ground: #15171b;
    --raised: #1e2127;
    --line: #343942;
    --text: #e6e8eb;
    --quiet: #a3abb7;
    --accent: #8fb3ff;
    --get: #7ed6a2;
    --post: #f2b661;
  }
}
* { box-sizing: border-box; }
html { scroll-padding-top: 1rem; }
body {
  margin: 0;
  display: grid;
  grid-template-columns: 18rem minmax(0, 1fr);
  background: var(--ground);
  color: var(--text);
  font: 15px/1.55 system-ui, sans-serif;
}
nav {
  position: sticky;
  top: 0;
  height: 100vh;
  overflow-y: auto;
  padding: 1.25rem;
  border-right: 1px solid var(--line);
  background: var(--raised);
}
nav h2 { margin: 1.25rem 0 0.25rem; border: 0; padding: 0; color: var(--quiet); font-size: 0.8rem; }
nav ul { margin: 0; padding: 0; list-style: none; }
nav li a { display: block; padding: 0.15rem 0; color: var(--text); overflow-wrap: anywhere; }
main { grid-column: 2; max-width: 62rem; padding: 1.5rem 2rem 5rem; }
main:first-child { grid-column: 1 / -1; }
h1 { margin: 0 0 0.5rem; font-size: 1.7rem; }
h2 { margin: 3rem 0 1rem; border-bottom: 1px solid var(--line); padding-bottom: 0.35rem; font-size: 1.3rem; }
h3 { margin: 0 0 0.5rem; font-size: 1.05rem; }
h4 { margin: 1rem 0 0.25rem; color: var(--quiet); font-size: 0.85rem; }
main > h3 { margin-top: 1.5rem; }
section { margin: 0 0 1.5rem; border: 1px solid var(--line); border-radius: 8px; padding: 1rem 1.25rem; }
section:target { border-color: var(--accent); }
p { margin: 0 0 0.75rem; }
a { color: var(--accent); text-decoration: none; }
a:hover { text-decoration: underline; }
code, pre { font: 0.87em/1.5 ui-monospace, "Cascadia Mono", "DejaVu Sans Mono", monospace; }
code { overflow-wrap: anywhere; }
pre { margin: 0.5rem 0 0; overflow-x: auto; border-radius: 6px; padding: 0.75rem 1rem; background: var(--raised); }
.home { font-weight: 600; }
.method {
  display: inline-block;
  min-width: 3.5rem;
  border: 1px solid currentcolor;
  border-radius: 4px;
  padding: 0 0.4rem;
  text-align: center;
  font-size: 0.75rem;
  color: var(--quiet);
}
.method.get { color: var(--get); }
.method.post { color: var(--post); }
.table { margin: 0 0 0.75rem; overflow-x: auto; }
table { width: 100%; border-collapse: collapse; font-size: 0.9em; }
th, td { border-bottom: 1px solid var(--line); padding: 0.35rem 0.75rem 0.35rem 0; text-align: left; vertical-align: top; }
th { color: var(--quiet); font-weight: 500; white-space: nowrap; }
td:first-child code { overflow-wrap: normal; white-space: nowrap; }
summary { margin-top: 0.5rem; cursor: pointer; color: var(--accent); }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
@media (max-width: 50rem) {
  body { grid-template-columns: minmax(0, 1fr); }
  nav { position: static; height: auto; border: 0; border-bottom: 1px solid var(--line); }
  main { grid-column: 1; padding: 1rem; }
  section { padding: 0.75rem; }
  table { min-width: 34rem; }
}
)";
}

}  // namespace dini::server
