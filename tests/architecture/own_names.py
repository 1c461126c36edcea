"""What a C++ file declares for itself alone: in unnamed namespaces, as static functions, as aliases of a namespace's scope.

Read by its lines, as clang-format leaves them; check_own_names.py and tests/tidy ask it which files can be read as one."""
import re
from typing import NamedTuple

NO_CODE = re.compile(
    r'R"(?P<end>\w*)\(.*?\)(?P=end)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|//[^\n]*|/\*.*?\*/|^#(?:[^\n]*\\\n)*[^\n]*',
    re.DOTALL | re.MULTILINE,
)
ATTRIBUTE = re.compile(r'^(?:\[\[[^\]]*\]\]|__attribute__\(\(\w+(?:\([^)]*\))?\)\))\s*')
NAMESPACE = re.compile(r"^namespace(?: ([\w:]+))? \{")
ALIAS = re.compile(r"(?:using|namespace) (\w+) = ([^;]+);|using (?!namespace )(?:::)?((?:\w+::)+(\w+));")
TYPE = re.compile(r"(?:struct|class|enum class|enum|union) (\w+)")
OTHER_KEYWORD = r"(?:using|namespace|template|static_assert|extern|struct|class|enum|union|[A-Z][A-Z_]+)\b"
VARIABLE_OR_FUNCTION = re.compile(
    rf"(?!{OTHER_KEYWORD})\w[^\n;={{(]*?[ &*>](?!operator\b)(\w+)(?:\[[^\]]*\])? ?([;={{(])"
)


class OwnName(NamedTuple):
    name: str  # with its namespaces; once more with the types of its parameters when it is a function's
    means: str  # files that say it with different meanings cannot be read as one
    line: int


def own_names(text, itself):
    """Yields them in the order of the lines; itself: stands for the file as the meaning of what it defines."""
    lines = NO_CODE.sub(lambda found: '""' * (found[0][0] in "R\"'") + "\n" * found[0].count("\n"), text).split("\n")
    scopes, depth = [], 0
    for at, line in enumerate(lines):
        if namespace := NAMESPACE.match(line):
            scopes.append(namespace[1] or "")
        elif depth == len(scopes):
            rest = ATTRIBUTE.sub("", "\n".join(lines[at : at + 12]))
            local = "" in scopes or rest.startswith("static ")
            for name, means in declared(rest, itself, local):
                yield OwnName("::".join(filter(None, [*scopes, name])), means, at + 1)
        depth += line.count("{") - line.count("}")
        del scopes[max(depth, 0) :]


def declared(rest, itself, local):
    """Yields name and meaning of what begins here; local: nobody else is meant to see it, alias or not."""
    if alias := ALIAS.match(rest):
        yield alias[1] or alias[4], " ".join((alias[2] or alias[3]).split()).removeprefix("weft::")
    elif local and (kind := TYPE.match(rest)):
        yield kind[1], itself
    elif local and (other := VARIABLE_OR_FUNCTION.match(rest)):
        if other[2] == "(":
            yield other[1], "a function"
            yield f"{other[1]}({types(rest[other.end() :])})", itself
        else:
            yield other[1], itself


def types(rest):
    """Of the parameters up to the closing parenthesis: without names, defaults, const and references."""
    depth, parts = 1, [""]
    for character in rest:
        depth += (character in "([{<") - (character in ")]}>")
        if depth == 0:
            break
        if character == "," and depth == 1:
            parts.append("")
        else:
            parts[-1] += character
    return ", ".join(type_of(part) for part in parts)


def type_of(parameter):
    words = re.sub(r"\bconst\b|&", " ", parameter.split("=")[0]).split()
    if len(words) > 1 and words[-1].isidentifier():
        words.pop()
    return " ".join(words)
