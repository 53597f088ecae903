#pragma once

/// Marks a function whose result the compiler must not derive at compile time: a value that depends
/// on the CRC of the image has to be computed when it runs. Clang, used only for tests, has no such
/// attribute.
#if defined(__clang__)
#define FOG_OPAQUE [[gnu::noinline]]
#else
#define FOG_OPAQUE [[gnu::noipa]]
#endif
