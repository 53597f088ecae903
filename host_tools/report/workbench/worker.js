// Runs in a web worker after emscripten's loader: one engine, one call at a time. A call brings the
// files that it needs and names the columns that it returns.
"use strict";
let engine = null;
const home = "/a/b/c/d/e/f/g/h";

// A copy of a column of the last `compare` or `preview`; null if there is none.
const column = (run, name) => {
  const place = engine._malloc(4);
  const first = engine.ccall("fogcomp_column", "number", ["number", "string", "number"], [run, name, place]);
  const count = engine.HEAP32[place >> 2];
  engine._free(place);
  return first ? engine.HEAPF64.slice(first >> 3, (first >> 3) + count) : null;
};

// Makes the missing folders of a path.
const make_folders = (path) => {
  const parts = path.split("/").slice(0, -1);
  parts.forEach((part, i) => {
    const folder = parts.slice(0, i + 1).join("/");
    if (part !== "" && !engine.FS.analyzePath(folder).exists) engine.FS.mkdir(folder);
  });
};

const answer = ({ words, files, columns }) => {
  for (const { name, bytes } of files) {
    make_folders(name);
    const read = bytes instanceof Uint8Array ? bytes : new Uint8Array(new FileReaderSync().readAsArrayBuffer(bytes));
    engine.FS.writeFile(name, read, { canOwn: true });
  }
  words.forEach((word, i) => {
    if (words[i - 1] === "-o") make_folders(word);
  });
  const found = JSON.parse(engine.ccall("fogcomp_call", "string", ["string"], [words.join("\n")]));
  const values = [];
  for (let run = 0; columns.length > 0 && column(run, columns[0]); ++run) {
    values.push(Object.fromEntries(columns.map((name) => [name, column(run, name)])));
  }
  return { found, values };
};

const start = (module) =>
  fogcompEngine({
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
      // Paths are those of the shell, which may begin with "../": the deep folder leaves room for them.
      make_folders(home + "/");
      engine.FS.chdir(home);
      postMessage({ id: data.id });
      return;
    }
    const { found, values } = answer(data);
    postMessage(
      { id: data.id, found, values },
      values.flatMap((run) =>
        Object.values(run)
          .filter(Boolean)
          .map((one) => one.buffer),
      ),
    );
  } catch (fault) {
    postMessage({ id: data.id, fault: String((fault && fault.message) || fault) });
  }
};
