#!/usr/bin/env bash
# Makes sure of what everything else is made with: python3, a C++ compiler, CMake, Ninja or make.
# With root it installs what is missing, otherwise it prints the one command that does.

give_up() {
	echo "$1" >&2
	exit 1
}

# Prints how somebody who is not root runs a command line as root on this machine.
as_root() {
	if command -v sudo >/dev/null; then echo "sudo sh -c '$1'"; else echo "su -c '$1'"; fi
}

# Prints the packages that are missing, of those that every job needs and of the named ones.
missing_packages() {
	local -a missing=()
	local program
	for program in "$@"; do
		command -v "$program" >/dev/null || missing+=("$program")
	done
	command -v python3 >/dev/null || missing+=(python3)
	python3 -c 'import ensurepip, venv' 2>/dev/null || missing+=(python3-venv)
	command -v c++ >/dev/null || missing+=(g++)
	command -v cmake >/dev/null || missing+=(cmake)
	command -v ninja >/dev/null || command -v make >/dev/null || missing+=(ninja-build)
	echo "${missing[*]-}"
}

bootstrap() {
	[ "$(uname -s)" = Linux ] || give_up "Dismount is built on Linux; this is $(uname -s)."
	[ "$(uname -m)" = x86_64 ] ||
		give_up "Dismount needs an x86_64 machine; this is $(uname -m). Use one, or build by hand as CONTRIBUTING.md says."
	grep -qm1 sse4_2 /proc/cpuinfo ||
		give_up "Godot needs a processor with SSE4.2, which this one lacks: use a newer machine."
	local packages
	packages=$(missing_packages "$@")
	[ -n "$packages" ] || return 0
	command -v apt-get >/dev/null ||
		give_up "These programs are missing, install them and start again: $packages"
	[ "$(id -u)" = 0 ] ||
		give_up "Some programs are missing. Install them and start again: $(as_root "apt-get update && apt-get install -y --no-install-recommends $packages")"
	echo "[ .. ] install $packages" >&2
	local said
	# shellcheck disable=SC2086
	said=$(apt-get -qq update 2>&1 &&
		DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends $packages 2>&1) ||
		give_up "apt-get could not install $packages: check the network and the mirror. It said: $(tail -n 2 <<<"$said")"
	packages=$(missing_packages "$@")
	[ -z "$packages" ] || give_up "apt-get installed no usable $packages: install them by hand and start again."
}
