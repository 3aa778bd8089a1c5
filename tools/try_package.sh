#!/usr/bin/env bash
# try_package.sh [FOLDER]: tries the packages in FOLDER (default: build/deb) on a fresh Debian 12. It makes a minimal
# system with debootstrap, installs tautline with apt, runs the program, its completions and its manual, installs
# libtautline-dev and libtautline-env1, builds examples with them and runs these, and removes the system again. Needs
# root and debootstrap.
#
# TAUTLINE_MIRROR names another mirror than http://deb.debian.org/debian.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-build/deb}
mirror=${TAUTLINE_MIRROR:-http://deb.debian.org/debian}

die() { echo "try_package.sh: $*" >&2; exit 1; }
((EUID == 0)) || die "debootstrap and chroot need root; run it with sudo"
command -v debootstrap >/dev/null || die "debootstrap is missing; tools/install_packages.sh package installs it"
packages=("$folder"/tautline_*.deb "$folder"/libtautline-dev_*.deb "$folder"/libtautline-env1_*.deb)
for package in "${packages[@]}"; do [[ -f $package ]] || die "there is no $package; \`make deb\` builds it"; done

system=$(mktemp -d)
remove_system() {
  # Never remove through a mount.
  if mountpoint -q "$system/proc" && ! umount "$system/proc"; then die "cannot unmount $system/proc; $system is left"; fi
  rm -rf --one-file-system "$system"
}
trap remove_system EXIT
chmod 755 "$system"
debootstrap --variant=minbase bookworm "$system" "$mirror" >"$folder/debootstrap.log" 2>&1 ||
  { tail "$folder/debootstrap.log" >&2; die "debootstrap failed"; }
rm "$folder/debootstrap.log"
mkdir "$system/packages"
cp "${packages[@]}" "$system/packages"
cp /etc/resolv.conf "$system/etc/resolv.conf"  # A chroot shares the network, but not the names of its servers.
mount -t proc proc "$system/proc"              # bash's <(...) needs /dev/fd, which leads there.
ln -sfn /proc/self/fd "$system/dev/fd"
# A minimal system leaves manuals out, as containers do; this one is to have them.
rm -f "$system"/etc/dpkg/dpkg.cfg.d/*

inside() {  # inside COMMAND...: runs it in the new system
  chroot "$system" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    "$@" </dev/null
}
install_packages() {
  inside apt-get install -q -y --no-install-recommends "$@" >"$system/apt.log" 2>&1 ||
    { tail -n 20 "$system/apt.log" >&2; die "cannot install $*"; }
}
expect() {  # expect PATTERN COMMAND...: what the command prints in the new system must match
  local pattern=$1 said
  shift
  said=$(inside "$@" 2>&1) || die "\`$*\` failed: $said"
  grep -Eq -- "$pattern" <<<"$said" || die "\`$*\` does not print '$pattern', but: $said"
  echo "ok: $*"
}

inside apt-get update -q >/dev/null
install_packages "/packages/$(basename "${packages[0]}")"
scene=/usr/share/doc/tautline/examples/scenes/two_ways.yaml
expect '^tautline [0-9]+\.[0-9]+\.[0-9]+$' tautline --version
expect '^Solved: the robot moves ' tautline plan "$scene" --verify
expect '^$' bash -c "tautline plan $scene --png /root/plan.png >/dev/null"  # Says so if there is no font.
[[ -s $system/root/plan.png ]] || die "there is no picture"
expect '^--unknown$' bash -c 'source /usr/share/bash-completion/completions/tautline
  COMP_WORDS=(tautline plan --unk) COMP_CWORD=2; _tautline; printf "%s\n" "${COMPREPLY[@]}"'
install_packages man-db zsh
expect '^NAME$' bash -c 'MANPAGER=cat MANWIDTH=80 man tautline | sed "s/.\x08//g"'
expect '^_tautline$' zsh -c 'autoload -Uz compinit; compinit -D; print -r -- $_comps[tautline]'

install_packages "/packages/$(basename "${packages[1]}")" "/packages/$(basename "${packages[2]}")" cmake g++ make python3
expect '13 6' bash -c 'cd /root && cmake -S /usr/share/doc/libtautline-dev/examples/plan_once -B once && cmake --build once &&
  once/plan_once'
expect 'solved' bash -c "cd /root && cmake -S /usr/share/doc/libtautline-dev/examples/replan -B replan &&
  cmake --build replan && replan/replan /usr/share/doc/tautline/examples/scenes/store_room.yaml 11.6,6.6 0.1"

expect "'at_goal': False" env PYTHONPATH=/usr/share/doc/libtautline-dev/examples/gymnasium python3 -B -c \
  "from tautline_env import TautlineEnv; env = TautlineEnv('$scene', robot_radius=0.1); env.reset(); print(env.step(1))"

inside apt-get purge -q -y tautline libtautline-dev libtautline-env1 >/dev/null 2>&1
# man's cache of pages is not the package's.
left=$(inside find / -xdev \( -path /proc -o -path /packages -o -path /var/cache/man \) -prune -o -name '*tautline*' -print)
[[ -z $left ]] || die "left behind after removal: $left"
echo "ok: removed without a trace"
