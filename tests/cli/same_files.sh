# To be sourced.

# Without the lines of how far slow work is, which a busy machine makes it say.
drop_progress() { sed -i -E '/^[a-z ]+: [0-9]+( %, [0-9]+ s left)?$/d' "$1"; }

# same_files A B: do two folders hold the same files, byte for byte? Prints where they do not. The time that Cairo packs
# into a PDF from version 1.18 on may be another.
same_files() {
  local file
  diff -rq -x '*.pdf' "$1" "$2" || return
  diff <(cd "$1" && find . -name '*.pdf' | sort) <(cd "$2" && find . -name '*.pdf' | sort) || return
  while read -r file; do
    cmp -s "$1/$file" "$2/$file" || grep -q /ObjStm "$2/$file" || { echo "$file differs" && return 1; }
  done < <(cd "$2" && find . -name '*.pdf')
}
