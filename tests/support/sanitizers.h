#pragma once

// Which sanitizer a test was compiled under: GCC says it by macros, Clang by features.

#if defined(__has_feature)
#define GEOLLOYD_TEST_HAS_FEATURE(name) __has_feature(name)
#else
#define GEOLLOYD_TEST_HAS_FEATURE(name) 0
#endif

namespace geolloyd {

#if defined(__SANITIZE_ADDRESS__) || GEOLLOYD_TEST_HAS_FEATURE(address_sanitizer)
inline constexpr bool under_address_sanitizer = true;
#else
inline constexpr bool under_address_sanitizer = false;
#endif

#if defined(__SANITIZE_THREAD__) || GEOLLOYD_TEST_HAS_FEATURE(thread_sanitizer)
inline constexpr bool under_thread_sanitizer = true;
#else
inline constexpr bool under_thread_sanitizer = false;
#endif

inline constexpr bool under_sanitizer = under_address_sanitizer || under_thread_sanitizer;

}  // namespace geolloyd
