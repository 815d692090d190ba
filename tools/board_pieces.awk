# Reads what readelf and objdump say of a relocatable object for the 68000 (readelf -SW, readelf -sW,
# readelf -rW, objdump -s, in this order, each after a line "# KIND") and prints its sections with
# contents as pieces of a board's program: words, and the long words that hold addresses. The routines
# arithmetic_NAME that none of them is are those of the arithmetic package, whose namespace `package` is.

BEGIN { pieces = 0 }

function piece_of_section(number) {
  if (!(number in piece)) {
    piece[number] = pieces
    section_of[pieces++] = number
  }
  return piece[number]
}

$1 == "#" { kind = $2; next }

kind == "sections" && match($0, /^ *\[ *[0-9]+\]/) {
  line = $0
  sub(/^ *\[ */, "", line)
  number = line + 0
  sub(/^[0-9]+\] */, "", line)
  split(line, field, / +/)
  name[number] = field[1]
  if (field[2] == "PROGBITS" && field[7] ~ /A/ && field[5] != "000000") {
    number_of[field[1]] = number
    piece_of_section(number)
  }
  if (field[2] == "RELA") {
    relocated_at[value_of(field[4])] = field[9]
  }
}

# Num: Value Size Type Bind Vis Ndx Name
kind == "symbols" && $1 ~ /^[0-9]+:$/ && $7 ~ /^[0-9]+$/ && $7 in piece {
  value = $2
  sub(/^0+/, "", value)
  offset_of[$8] = $2
  home_of[$8] = $7
}

# The offset tells which section is meant, since readelf cuts long names here.
kind == "relocations" && /^Relocation section/ {
  match($0, /at offset 0x[0-9a-f]+/)
  target = relocated_at[value_of(substr($0, RSTART + 10, RLENGTH - 10))]
  if (!(target in piece)) {
    print "relocations of what is no piece: " $0 > "/dev/stderr"
    failed = 1
    exit 1
  }
}
kind == "relocations" && $3 ~ /^R_68K/ {
  if ($3 != "R_68K_32") {
    print "a relocation of kind " $3 > "/dev/stderr"
    failed = 1
    exit 1
  }
  # Offset Info Type Value Name + Addend
  place = piece[target]
  relocations[place] = relocations[place] $1 " " $5 " " $7 "\n"
}

kind == "contents" && /^Contents of section/ {
  section = $4
  sub(/:$/, "", section)
}
kind == "contents" && /^ [0-9a-f]+ / && section in number_of {
  hex = substr($0, index(substr($0, 2), " ") + 2, 35)
  gsub(/ /, "", hex)
  contents[piece[number_of[section]]] = contents[piece[number_of[section]]] hex
}

function value_of(hexadecimal, digits, i, sum) {
  digits = tolower(hexadecimal)
  sub(/^0x/, "", digits)
  for (i = 1; i <= length(digits); ++i) {
    sum = sum * 16 + index("0123456789abcdef", substr(digits, i, 1)) - 1
  }
  return sum
}

END {
  if (failed) exit 1
  for (p = 0; p < pieces; ++p) {
    short = name[section_of[p]]
    sub(/^\.(text|rodata|data\.rel\.ro\.local|data\.rel\.ro)\./, "", short)
    words = length(contents[p]) / 4
    if (words != int(words)) {
      contents[p] = contents[p] "00"
      words = int(words) + 1
    }
    count = split(relocations[p], rows, "\n") - 1
    if (count < 0) count = 0
    printf "piece\t%s\t%d\t%d\t%d\t%d\n", short, first_word, words, first_address, count
    for (w = 0; w < words; ++w) {
      printf "word\t%s\n", substr(contents[p], 4 * w + 1, 4)
    }
    for (r = 1; r <= count; ++r) {
      split(rows[r], part, " ")
      symbol = part[2]
      if (symbol in home_of) {
        home = home_of[symbol]
        addend = value_of(offset_of[symbol]) + value_of(part[3])
      } else if (symbol in number_of) {
        home = number_of[symbol]
        addend = value_of(part[3])
      } else if (sub(/^arithmetic_/, "", symbol)) {
        printf "address\t%d\tk_package\t%s::k_%s_entry\n", value_of(part[1]), package, symbol
        continue
      } else {
        print "nothing has the name " symbol > "/dev/stderr"
        exit 1
      }
      printf "address\t%d\t%d\t%d\n", value_of(part[1]), piece[home], addend
    }
    first_word += words
    first_address += count
  }
}
