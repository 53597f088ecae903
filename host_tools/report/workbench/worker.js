// In a worker, behind emscripten's loader: one engine, one call after the other. A call brings the
// files that it needs and names the columns that it wants back.
"use strict";
let engine = null;

const column = (run, name) => {
  const place = engine._malloc(4);
  const first = engine.ccall("fogcomp_column", "number", ["number", "string", "number"], [run, name, place]);
  const count = engine.HEAP32[place >> 2];
  engine._free(place);
  return first ? engine.HEAPF64.slice(first >> 3, (first >> 3) + count) : null;
};

const answer = ({ words, files, columns }) => {
  for (const { name, bytes } of files) engine.FS.writeFile(name, bytes);
  const found = JSON.parse(engine.ccall("fogcomp_call", "string", ["string"], [words.join("\n")]));
  const values = [];
  for (let run = 0; columns.length > 0 && column(run, columns[0]); ++run) {
    values.push(Object.fromEntries(columns.map((name) => [name, column(run, name)])));
  }
  return { found, values };
};

const start = (module) => fogcompEngine({
  instantiateWasm: (imports, done) => {
    WebAssembly.instantiate(module, imports).then(done);
    return {};
  },
  progress: (stage, done) => postMessage({ stage, done }),
  print: () => {},
  printErr: () => {},
});

onmessage = async ({ data }) => {
  try {
    if (data.module) {
      engine = await start(data.module);
      postMessage({ id: data.id });
      return;
    }
    const { found, values } = answer(data);
    postMessage({ id: data.id, found, values }, values.flatMap((run) => Object.values(run).filter(Boolean).map((one) => one.buffer)));
  } catch (fault) {
    postMessage({ id: data.id, fault: String(fault && fault.message || fault) });
  }
};
