// Replaces the header that Eigen includes first for SSE2: Emscripten's SSE2 has no MMX. Removes
// Eigen's empty assembler statements (hints to GCC's register allocator on x86).
#define __asm__(...)
