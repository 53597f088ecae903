// Alters the WebAssembly engine of a page so that it fails: a function that traps, or less memory.
import { readFileSync } from "node:fs";
import { gunzipSync } from "node:zlib";

// Reads a WebAssembly module: sections, names, LEB128 numbers.
class Module {
  constructor(bytes) {
    this.bytes = bytes;
  }
  number(at) {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = this.bytes[at++];
      value |= (byte & 127) << shift;
      if (byte < 128) return { value, at };
    }
  }
  section(wanted) {
    for (let at = 8; at < this.bytes.length; ) {
      const id = this.bytes[at];
      const size = this.number(at + 1);
      if (id === wanted) return this.number(size.at); // how many it has, and where they begin
      at = size.at + size.value;
    }
    throw new Error(`no section ${wanted}`);
  }
  name(at) {
    const length = this.number(at);
    return { text: this.bytes.subarray(length.at, length.at + length.value).toString(), at: length.at + length.value };
  }
  imported_functions() {
    let { value: left, at } = this.section(2);
    let count = 0;
    for (; left > 0; --left) {
      at = this.name(this.name(at).at).at;
      const kind = this.bytes[at++];
      if (kind === 0) ++count;
      if (kind === 1) ++at; // a table: type of its elements, then limits
      if (kind === 0) at = this.number(at).at;
      else if (kind === 1 || kind === 2) at = this.limits(at);
      else if (kind === 3) at += 2;
      else at = this.number(at + 1).at; // a tag
    }
    return count;
  }
  limits(at) {
    const first = this.number(at + 1).at;
    return this.bytes[at] === 0 ? first : this.number(first).at;
  }
  exported(name) {
    let { value: left, at } = this.section(7);
    for (; left > 0; --left) {
      const one = this.name(at);
      const index = this.number(one.at + 1);
      if (one.text === name) return index.value;
      at = index.at;
    }
    throw new Error(`no export ${name}`);
  }
  body(index) {
    let { at } = this.section(10);
    for (let i = this.imported_functions(); i < index; ++i) {
      const size = this.number(at);
      at = size.at + size.value;
    }
    const size = this.number(at);
    return this.bytes.subarray(size.at, size.at + size.value);
  }
}

const module_of = (page) => {
  const packed = readFileSync(page, "utf8").match(/id="engine">([^<]*)</)[1];
  return new Module(gunzipSync(Buffer.from(packed, "base64")));
};

// The engine of that page as base64; its exported function `name` traps.
export const trapping = (page, name) => {
  const module = module_of(page);
  const body = module.body(module.exported(name));
  body.fill(1); // nop
  body.set([0, 0], 0); // no locals; unreachable
  body[body.length - 1] = 11;
  return module.bytes.toString("base64");
};
// The engine of that page as base64, its memory limited to `pages` of 64 KiB.
export const with_memory = (page, pages) => {
  const module = module_of(page);
  const { at } = module.section(5);
  const max = module.number(at + 1).at; // behind the flag and the minimum
  const length = module.number(max).at - max;
  for (let i = 0; i < length; ++i) module.bytes[max + i] = ((pages >> (7 * i)) & 127) | (i + 1 < length ? 128 : 0);
  return module.bytes.toString("base64");
};
