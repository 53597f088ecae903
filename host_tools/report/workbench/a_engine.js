// The engine in its workers: compiled once, started as often as needed.
"use strict";
const text_of = (id) => document.getElementById(id).textContent;

const bytes_of = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));

const compile_engine = async () => {
  const packed = new Blob([bytes_of(text_of("engine"))]).stream();
  const unpacked = packed.pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(unpacked).arrayBuffer());
};

// Calls are answered in turn. What a worker has read it keeps; `files` are what another one needs to
// take its place: after a cancelled call, or when the engine has failed.
class Engine {
  #module;
  #worker = null;
  #waiting = new Map();
  #id = 0;
  #there = new Set(); // names of files that the worker has

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
    this.#there.clear();
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

  // A trap leaves the engine in no state to go on: another one takes its place, and what was asked
  // for meanwhile is told why it has no answer.
  #fail(what) {
    const error = `The engine stopped (${what}) and was started again. Nothing that was shown is lost.`;
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

  // A file for the calls to come, in the place of one of that name.
  put(name, bytes) {
    this.files.set(name, bytes);
    this.#there.delete(name);
  }

  // Ends what is under way; its callers are told nothing more.
  cancel() {
    if (!this.busy) return;
    this.#waiting.forEach(({ reject }) => reject(new Cancelled()));
    this.#waiting.clear();
    this.#worker.terminate();
    this.on_progress(null);
    this.#start();
  }

  async call(words, columns = []) {
    const files = [...this.files].filter(([name]) => !this.#there.has(name)).map(([name, bytes]) => ({ name, bytes }));
    files.forEach(({ name }) => this.#there.add(name));
    return this.#send({ words, columns, files });
  }
}

class Cancelled extends Error {
  constructor() {
    super("Cancelled.");
  }
}
