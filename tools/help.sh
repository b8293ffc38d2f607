#!/usr/bin/env bash
# What needs nothing but a shell and a checkout: help, the version, the list of benchmarks, and the
# answer to a command or option that there is not. The texts in tools/help are made by
# ./run options-doc.

# Prints the description at the top of a benchmark.
describe_benchmark() {
	local line is_inside=""
	while IFS= read -r line; do
		case $1:$line in
		*.gd:\#\#*)
			is_inside=yes
			line=${line#\#\#}
			printf '%s\n' "${line# }"
			;;
		*.py:\"\"\"*\"\"\")
			line=${line#\"\"\"}
			printf '%s\n' "${line%\"\"\"}"
			return
			;;
		*.py:\"\"\"*)
			[ -z "$is_inside" ] || return 0
			is_inside=yes
			printf '%s\n' "${line#\"\"\"}"
			;;
		*.py:*) [ -z "$is_inside" ] || printf '%s\n' "$line" ;;
		*) [ -z "$is_inside" ] || return 0 ;;
		esac
	done <"$1"
}

# Prints a line for each benchmark, or the whole description of one.
list_benchmarks() {
	local script name about
	for script in tests/bench/bench_*.gd tests/bench/bench_*.py; do
		case $(head -n 1 "$script") in
		class_name*) continue ;;
		esac
		name=${script##*/bench_}
		name=${name%.*}
		if [ "${1-}" = "$name" ]; then
			describe_benchmark "$script"
			exit 0
		fi
		about=$(describe_benchmark "$script")
		[ -n "${1-}" ] || printf '%-12s %s\n' "$name" "${about%%$'\n'*}"
	done
}

show_version() {
	local line
	while IFS= read -r line; do
		case $line in
		config/version=*)
			line=${line#*\"}
			echo "Dismount ${line%\"*}"
			;;
		esac
	done <project.godot
}

# The words that are no options, up to a "--", in the array "words"; whether help is asked for in "wants_help".
read_words() {
	words=()
	wants_help=""
	local argument
	for argument in "$@"; do
		case $argument in
		--) break ;;
		-h | --help) wants_help=yes ;;
		-*) ;;
		*) words+=("$argument") ;;
		esac
	done
	if [ "${words[0]-}" = help ]; then
		wants_help=yes
		words=("${words[@]:1}")
	fi
}

# Prints how many letters have to be changed, added, removed or exchanged with their neighbour to make
# one word of another; see scripts/core/nearest.gd.
count_edits() {
	local from=$1 to=$2 i j edits
	local before=() last=() row=()
	for ((j = 0; j <= ${#to}; j++)); do last[j]=$j; done
	for ((i = 0; i < ${#from}; i++)); do
		row=($((i + 1)))
		for ((j = 0; j < ${#to}; j++)); do
			edits=$((last[j] + 1))
			[ "${from:i:1}" != "${to:j:1}" ] || edits=${last[j]}
			((edits <= last[j + 1])) || edits=$((last[j + 1] + 1))
			((edits <= row[j])) || edits=$((row[j] + 1))
			if ((i > 0 && j > 0)) && [ "${from:i-1:2}" = "${to:j:1}${to:j-1:1}" ]; then
				((edits <= before[j - 1])) || edits=$((before[j - 1] + 1))
			fi
			row+=("$edits")
		done
		before=("${last[@]}")
		last=("${row[@]}")
	done
	echo "${last[${#to}]}"
}

# Prints a question to put behind a complaint about the first word: which of the others was meant, if
# one is near enough; else where to look.
suggest() {
	local word=${1,,} least best="" known edits
	least=$((1 + (${#word} < 6 ? 1 : ${#word} / 3)))
	shift
	for known in "$@"; do
		[ ${#word} -le 64 ] || break
		edits=$(count_edits "$word" "$known")
		if [ "$edits" -lt "$least" ]; then
			least=$edits
			best=$known
		fi
	done
	if [ -n "$best" ]; then echo ": did you mean $best?"; else echo ": see ./run --help."; fi
}

# Ends if there is no such command.
check_command() {
	[ ! -f "tools/help/$1.txt" ] || return 0
	local names=(tools/help/*.txt help)
	names=("${names[@]##*/}")
	echo "There is no command '$1'$(suggest "$1" "${names[@]%.txt}")" >&2
	exit 2
}

# Ends if one of the options before a "--" is none of ./run itself.
check_own_options() {
	local known=(--help --version) line argument
	while IFS= read -r line; do
		line=${line#"${line%%[! ]*}"}
		case $line in
		--*) known+=("${line%%[= ]*}") ;;
		esac
	done <tools/help.txt
	for argument in "$@"; do
		case $argument in
		--) return ;;
		--*)
			argument=${argument%%=*}
			case " ${known[*]} " in
			*" $argument "*) ;;
			*)
				echo "./run has no option $argument$(suggest "$argument" "${known[@]}")" >&2
				exit 2
				;;
			esac
			;;
		esac
	done
}

# Answers what needs no set-up, and ends; otherwise returns.
answer_at_once() {
	local words wants_help
	read_words "$@"
	local command=${words[0]-}
	if [ "${1-}" = --version ]; then
		show_version
		exit 0
	fi
	case ${1-} in
	-*)
		command=""
		check_own_options "$@"
		;;
	esac
	[ -z "$command" ] || check_command "$command"
	if [ "$command" = bench ]; then
		if [ -n "$wants_help" ] && [ -n "${words[1]-}" ]; then
			list_benchmarks "${words[1]}"
		elif [ -n "$wants_help" ]; then
			cat tools/help/bench.txt
			list_benchmarks
			exit 0
		elif [ $# = 1 ]; then
			list_benchmarks
			exit 0
		fi
		return 0
	fi
	[ -n "$wants_help" ] || return 0
	if [ -n "$command" ]; then cat "tools/help/$command.txt"; else cat tools/help.txt; fi
	exit 0
}
