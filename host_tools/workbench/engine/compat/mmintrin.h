// Eigen includes this first of all for SSE2. Emscripten's SSE2 has no MMX; and Eigen's hints to the
// register allocator of a GCC for x86, empty assembler statements, mean nothing to WebAssembly.
#define __asm__(...)
