#!/usr/bin/env bash
# forbidden_symbols_bite.sh: each thing the firmware must not use is found in an object that uses it,
# and what it may use is let through.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
check=$(dirname "$0")/forbidden_symbols.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# expect_status STATUS NAME CODE: the verdict on an object compiled from CODE.
expect_status() {
  local status=0
  echo "$3" | arm-none-eabi-g++ -mcpu=cortex-m4 -mthumb -mfloat-abi=soft -O1 -x c++ -c - \
    -o "$scratch/$2.o"
  "$check" "$scratch/$2.o" || status=$?
  ((status == $1)) || fail "$2: exit code $status, not $1"
}

expect_status 1 float_product 'float f(float a, float b) { return a * b; }'
expect_status 1 float_comparison 'bool f(float a, float b) { return a < b; }'
expect_status 1 float_from_int 'float f(int a) { return a; }'
expect_status 1 float_from_int64 'float f(unsigned long long a) { return a; }'
expect_status 1 double_sum 'double f(double a, double b) { return a + b; }'
expect_status 1 double_to_int 'int f(double a) { return a; }'
expect_status 1 double_comparison 'bool f(double a, double b) { return a == b; }'
expect_status 1 heap 'extern "C" void* malloc(unsigned); void* f() { return malloc(4); }'
expect_status 1 new_operator 'int* f() { return new int; }'
expect_status 1 delete_operator 'void f(int* p) { delete p; }'
expect_status 1 exception 'void f() { throw 1; }'
expect_status 1 virtual_function 'struct A { virtual int f(); }; int A::f() { return 1; }'
expect_status 1 guarded_static 'int g(); int f() { static int x = g(); return x; }'
expect_status 0 int64_division 'long long f(long long a, long long b) { return a / b; }'
expect_status 0 int64_remainder 'unsigned long long f(unsigned long long a) { return a % 10; }'
expect_status 0 int_division 'int f(int a, int b) { return a / b; }'
