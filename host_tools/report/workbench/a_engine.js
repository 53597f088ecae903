// The engine (WebAssembly) in web workers: compiled once, started as often as needed.
"use strict";
const text_of = (id) => document.getElementById(id).textContent;

const bytes_of = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));

const compile_engine = async () => {
  const packed = new Blob([bytes_of(text_of("engine"))]).stream();
  const unpacked = packed.pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(unpacked).arrayBuffer());
};

// One worker, which answers calls in turn and keeps the recordings that it has read. `files` (name to
// bytes, or to a File) is what a new worker gets if this one is replaced: after a cancelled call or a failure.
// on_progress(stage, done): stage null at the end, done 0 to 1. on_fault(message).
class Engine {
  #module;
  #worker = null;
  #waiting = new Map();
  #id = 0;
  #sent = new Set(); // names of files that the worker has

  constructor(module, files, on_progress, on_fault) {
    this.#module = module;
    this.files = files;
    this.on_progress = on_progress;
    this.on_fault = on_fault;
    this.#start();
  }

  #start() {
    const address = URL.createObjectURL(new Blob([text_of("engine_script")], { type: "text/javascript" }));
    this.#worker = new Worker(address);
    URL.revokeObjectURL(address);
    this.#sent.clear();
    this.#worker.onmessage = ({ data }) => this.#take(data);
    this.#worker.onerror = (event) => this.#fail(event.message || "the engine did not start");
    this.#send({ module: this.#module }).catch(() => {});
  }

  #send(message) {
    const id = ++this.#id;
    this.#worker.postMessage({ ...message, id });
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }

  #take(data) {
    if (data.id === undefined) {
      this.on_progress(data.stage, data.done);
      return;
    }
    this.on_progress(null);
    if (data.fault !== undefined) {
      this.#fail(data.fault);
      return;
    }
    this.#waiting.get(data.id).resolve(data);
    this.#waiting.delete(data.id);
  }

  // A trap leaves the engine unusable: replaces the worker and answers all waiting calls with the error.
  #fail(what) {
    const error = `The engine stopped (${what}) and was started again. The model is unchanged: try again.`;
    const callers = [...this.#waiting.values()];
    this.#waiting.clear();
    this.#worker.terminate();
    this.#start();
    callers.forEach(({ resolve }) => resolve({ found: { error }, values: [] }));
    this.on_fault(error);
  }

  get busy() {
    return this.#waiting.size > 0;
  }

  // Gives the following calls a file; it replaces one of that name.
  put(name, bytes) {
    this.files.set(name, bytes);
    this.#sent.delete(name);
  }

  remove(name) {
    this.files.delete(name);
  }

  // Stops the running call and those that wait; they are rejected with Cancelled.
  cancel() {
    if (!this.busy) return;
    this.#waiting.forEach(({ reject }) => reject(new Cancelled()));
    this.#waiting.clear();
    this.#worker.terminate();
    this.on_progress(null);
    this.#start();
  }

  // `words`: a command line without "fogcomp". Resolves to { found: its JSON, values: for each run an
  // object with the columns asked for }.
  async call(words, columns = []) {
    const files = [...this.files].filter(([name]) => !this.#sent.has(name)).map(([name, bytes]) => ({ name, bytes }));
    files.forEach(({ name }) => this.#sent.add(name));
    return this.#send({ words, columns, files });
  }
}

class Cancelled extends Error {
  constructor() {
    super("Cancelled.");
  }
}
