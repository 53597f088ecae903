#pragma once

/// A function whose result the compiler may not foresee: what it computes from the CRC of the image
/// must be computed, not concluded. Clang, which only builds tests, has no word for it.
#if defined(__clang__)
#define FOG_OPAQUE [[gnu::noinline]]
#else
#define FOG_OPAQUE [[gnu::noipa]]
#endif
