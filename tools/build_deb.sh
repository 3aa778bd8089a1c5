#!/usr/bin/env bash
# build_deb.sh FOLDER [JOBS]: builds tautline_*.deb, libtautline-env1_*.deb and libtautline-dev_*.deb with Debian's
# compiler flags into FOLDER, which is emptied before, and lints them: a warning of lintian is an error.
set -euo pipefail
cd "$(dirname "$0")/.."
out=${1:?build_deb.sh FOLDER [JOBS]}
jobs=${2:-$(nproc)}

# No debug symbols: they would end up in the static libraries.
export CMAKE_GENERATOR=Ninja DEB_BUILD_MAINT_OPTIONS=hardening=+all DEB_CXXFLAGS_MAINT_STRIP=-g
cmake --preset package \
  -DCMAKE_CXX_FLAGS="$(dpkg-buildflags --get CPPFLAGS) $(dpkg-buildflags --get CXXFLAGS)" \
  -DCMAKE_EXE_LINKER_FLAGS="$(dpkg-buildflags --get LDFLAGS)" \
  -DCMAKE_SHARED_LINKER_FLAGS="$(dpkg-buildflags --get LDFLAGS)"
cmake --build --preset package --parallel "$jobs"

rm -rf "$out"
mkdir -p "$out"
cpack --config build/package/CPackConfig.cmake -B "$out/work"
mv "$out"/work/*.deb "$out"
rm -r "$out/work"

as_user=()
((EUID == 0)) && as_user=(--allow-root)
lintian "${as_user[@]}" --fail-on error,warning "$out"/*.deb
ls -l "$out"/*.deb
