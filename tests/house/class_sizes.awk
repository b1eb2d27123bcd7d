# Reads C++ sources, headers first, and prints for each class, struct and union
#   class NAME FUNCTIONS LINES FILE
# with the number of member functions that it declares (including defaulted and deleted ones; nested
# classes count separately), and the lines of its body and of its members' definitions in all files.
# For each member that is a reference it prints
#   reference NAME LINE FILE
# It parses just enough of C++ for code that clang-format has formatted and that uses no macros.

FNR == 1 {
  if (source != "") read_source()
  source = FILENAME
  code = ""
  in_comment = in_directive = 0
}
{ code = code without_comments($0) "\n" }
END {
  if (source != "") read_source()
  for (i = 1; i <= classes; ++i) print "class", name[i], functions[i] + 0, lines[i], file[i]
}

# A line of code without comments, preprocessor directives and the contents of quotes.
function without_comments(line,    out, i, c, two) {
  if (in_directive || (!in_comment && line ~ /^[ \t]*#/)) {
    in_directive = line ~ /\\$/
    return ""
  }
  out = ""
  for (i = 1; i <= length(line); ++i) {
    c = substr(line, i, 1)
    two = substr(line, i, 2)
    if (in_comment) {
      if (two == "*/") { in_comment = 0; ++i }
    } else if (two == "//") {
      break
    } else if (two == "/*") {
      in_comment = 1
      ++i
    } else if (c == "\"" || (c == "'" && out !~ /[0-9A-Za-z]$/)) {  # no separator of digits
      for (++i; i <= length(line) && substr(line, i, 1) != c; ++i)
        if (substr(line, i, 1) == "\\") ++i
      out = out "0"
    } else {
      out = out (c == "\t" ? " " : c)
    }
  }
  return out
}

# Parses the declarations of one source.
function read_source(    at, c, parens, text) {
  depth = parens = 0
  line = 1
  head = ""  # of the declaration at hand, as far as it was read
  for (at = 1; at <= length(code); ++at) {
    c = substr(code, at, 1)
    if (head == "" && c !~ /[ \n]/) head_line = line
    if (c == "\n") { ++line; c = " " }
    if (c == "(") ++parens
    if (c == ")") --parens
    if (c == ";" && parens == 0) {
      end_declaration(0)
    } else if (c == "}") {
      if (depth > 0 && scope[depth] > 0) lines[scope[depth]] += line - first_line[depth] + 1
      --depth
      head = ""
    } else if (c == "{") {
      text = bare(head)
      if (parens == 0 && text ~ /^((inline )?namespace|extern)( |$)/) {
        enter(0)
      } else if (parens == 0 && text ~ /(^| )(class|struct|union) / && text !~ /^enum |\(|=/) {
        enter(new_class(text))
      } else {
        at = end_of_braces(at)
        head = head "{}"
        # A list of initialisers continues, and so does a call with braces.
        if (parens == 0 && substr(code, at + 1) !~ /^[ \n]*[,{]/) end_declaration(1)
      }
    } else if (c != " " || head != "") {
      head = head c
    }
  }
}

function enter(class) {
  scope[++depth] = class
  first_line[depth] = head_line
  head = ""
}

# Returns the position of the brace that closes the one at `at`.
function end_of_braces(at,    open, c) {
  open = 0
  for (; at <= length(code); ++at) {
    c = substr(code, at, 1)
    if (c == "\n") ++line
    if (c == "{") ++open
    if (c == "}" && --open == 0) return at
  }
  return at
}

function new_class(text,    own, i) {
  match(text, /(class|struct|union) +[A-Za-z_][A-Za-z_0-9:]*/)
  own = substr(text, RSTART, RLENGTH)
  sub(/^[a-z]+ +/, "", own)
  sub(/:+$/, "", own)
  for (i = depth; i > 0 && scope[i] > 0; --i) own = name[scope[i]] "::" own
  # Each source has its own unnamed namespace.
  number[source ~ /\.h$/ ? own : source " " own] = ++classes
  name[classes] = own
  file[classes] = source
  return classes
}

function end_declaration(with_body,    text, class) {
  text = bare(head)
  head = ""
  if (text == "") return
  class = depth > 0 ? scope[depth] : 0
  if (class > 0) {
    if (is_function(text)) ++functions[class]
    else if (text ~ /&/ && text !~ /^(using|typedef|friend|static_assert)[^A-Za-z_]/)
      print "reference", name[class], head_line, source
  } else if (with_body && is_function(text)) {
    class = class_of_definition(text)
    if (class > 0) lines[class] += line - head_line + 1
  }
}

# A declaration without the parts that hide whether it is a function.
function bare(text) {
  gsub(/operator *\( *\)/, "operator_", text)
  gsub(/operator *[^A-Za-z_0-9( ]+/, "operator_", text)
  gsub(/\[\[[^]]*\]\]/, "", text)
  gsub(/alignas *\([^)]*\)/, "", text)
  while (sub(/<[^<>]*>/, "", text)) {}
  gsub(/(public|private|protected) *:/, "", text)
  gsub(/  +/, " ", text)
  sub(/^ /, "", text)
  sub(/^template */, "", text)
  return text
}

# Whether there are parentheses other than those of an initialiser or of a pointer to a function.
function is_function(text,    open, equals) {
  if (text ~ /^(using|typedef|friend|static_assert|enum)[^A-Za-z_]/) return 0
  open = index(text, "(")
  equals = index(text, "=")
  if (open == 0 || (equals > 0 && equals < open)) return 0
  return substr(text, open) !~ /^\( *[*&] *[A-Za-z_0-9]* *\)/
}

# The class of a definition such as `Type Class::function(...)`, or 0.
function class_of_definition(text,    own) {
  own = substr(text, 1, index(text, "(") - 1)
  sub(/ +$/, "", own)
  sub(/^.*[ *&]/, "", own)
  if (own !~ /::/) return 0
  sub(/::[^:]*$/, "", own)
  if ((source " " own) in number) return number[source " " own]
  return own in number ? number[own] : 0
}
