#!/usr/bin/env bash
# transcript.sh PROGRAM TRANSCRIPT [--update]
# Runs every "$ <program> <arguments>" line of a transcript and compares what the program says now with what is written
# there: stdout as it is, stderr after "! ", the exit code after "? ". Digits that rounding may change are masked by
# "#", and so are residuals in a CSV, which are nothing but rounding: numbers below 1e-9.
set -u
program=$(realpath "$1") transcript=$(realpath "$2") update=${3:-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

mask() {
  local e='[0-9]e[-+][0-9]+'
  sed -E \
    -e "s/^(.*(LN_[A-Z]+|LD_[A-Z]+|closed form|bracketed root)) +[0-9]+ +$e +$e +(nlopt|direct) +$e\$/\\1  #/" \
    -e 's/^(\|.*\|) [0-9]+ \| [0-9]e[-+][0-9]+ \| [0-9]e[-+][0-9]+ \| (nlopt|direct) \| [0-9]e[-+][0-9]+ \|$/\1 # |/' \
    -e '/"(achieved|residual)": \{/,/\}/ s/: -?[0-9][0-9.e+-]*/: #/' \
    -e 's/("(evaluations|max_relative_difference)"): [0-9.e+-]+/\1: #/' \
    -e '/"(value|standard_error)":/ s/([0-9]{4}\.[0-9]{4}|[0-9]{2}\.[0-9]{6})[0-9]+/\1#/' \
    -e 's/,-?[0-9]\.[0-9]{6,}e-1[0-9]/,#/g' \
    -e 's/([0-9]\.[0-9]{8})[0-9]+/\1#/g' \
    -e 's/[[:space:]]+$//'
}

run() {
  echo "\$ $1"
  # The transcripts are the project's own; eval gives their quotes and redirections their meaning.
  eval "\"$program\" ${1#"$(basename "$program")"}" >out 2>err
  local code=$?
  mask <out
  # How far slow work is, which a busy machine makes it say.
  mask <err | sed -E '/^[a-z ]+: [0-9]+( %, [0-9]+ s left)?$/d; s/^/! /'
  echo "? $code"
}

# A "#" between a command and its exit code belongs to what was printed; elsewhere it is the transcript's own remark.
printed=
while IFS= read -r line; do
  case $line in
    '$ '*) run "${line#\$ }"; echo; printed=yes ;;
    '? '*) printed= ;;
    '#'*) [ -n "$printed" ] || echo "$line" ;;
  esac
done <"$transcript" >now

if [ "$update" = --update ]; then
  cp now "$transcript"
else
  diff -u "$transcript" now
fi
