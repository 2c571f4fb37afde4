// Stand-in for the header that CCCoreLib's own build generates.
#pragma once
#define CC_CORE_LIB_API __attribute__((visibility("default")))
#define CC_CORE_LIB_NO_EXPORT __attribute__((visibility("hidden")))
