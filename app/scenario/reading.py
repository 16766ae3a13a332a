"""Bytes become a tree of nodes, or are refused before anything is built from them."""

import re
from bisect import bisect_right
from collections.abc import Sequence

from ruamel.yaml import YAML
from ruamel.yaml.error import MarkedYAMLError
from ruamel.yaml.events import (
    AliasEvent,
    CollectionStartEvent,
    DocumentStartEvent,
    Event,
    MappingEndEvent,
    MappingStartEvent,
    NodeEvent,
    ScalarEvent,
    SequenceEndEvent,
)

from app.scenario.mistakes import Mistake, Place, Refused, quote, refuse, visible
from app.scenario.nodes import ListNode, MapNode, Node, ScalarNode

LARGEST = 256 * 1024
"""Bytes of a file at most."""

DEEPEST = 32
"""Nested lists and mappings at most."""

_LINE_END = re.compile("\r\n|[\n\r\x85\u2028\u2029]")
_UNPRINTABLE = re.compile(
    "[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x84\x86-\x9f\ud800-\udfff\ufeff\ufffe\uffff]"
)
_DIRECTIVE = re.compile(r"^%\S*", re.MULTILINE)
_NO_CHARACTER = re.compile(r"\\U(?!000|0010)[0-9A-Fa-f]{8}")
_TAB = re.compile(r"^ *\t[ \t]*(?=[^ \t\r\n])", re.MULTILINE)


def read(content: bytes, path: str) -> tuple[Node, Sequence[Mistake]]:
    """The tree of a file's bytes, and what may not stand there; `path` names it in mistakes.

    The tree does without what is not allowed, so that the rest can be examined: of a key that was
    given twice it holds the first value, and tabs, anchors, tags and directives are left out.
    Raises Refused with all that can be told if there is no tree: too large, not UTF-8, too deep,
    not YAML, empty, or a mapping that takes its keys from elsewhere.
    """
    if len(content) > LARGEST:
        raise refuse(
            Place(path, 1, 1),
            "too-large",
            f"the file is larger than {LARGEST} bytes (256 KiB)",
        )
    text = _Text(_decode(content, path), path)
    odd = text.leave_out_odd_parts()
    builder = _Builder(text)
    try:
        return builder.document(), [*odd, *builder.mistakes]
    except Refused as refused:
        if not odd:
            raise
        noted = [m for m in refused.mistakes if m.code != "syntax"]  # they may follow from the odd
        raise Refused(*odd, *noted) from None


def _decode(content: bytes, path: str) -> str:
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        before = content[: error.start].decode("utf-8", errors="replace").lstrip("\ufeff")
        after = content[error.start :].decode("utf-8", errors="replace")
        bad = content[error.start]
    lines = _LINE_END.split(before)
    rest = _LINE_END.split(after)[0]
    raise refuse(
        Place(path, len(lines), len(lines[-1]) + 1, 1, lines[-1] + rest),
        "not-utf8",
        f"the file is not UTF-8: the byte 0x{bad:02x} does not belong there",
        "save the file as UTF-8",
    )


class _Text:
    """The text of a file, addressed by line and column."""

    def __init__(self, text: str, path: str) -> None:
        self.text = text
        self.path = path
        ends = [match.end() for match in _LINE_END.finditer(text)]
        self.starts = [0, *ends]
        self.lines = _LINE_END.split(text)

    def place(self, line: int, column: int, length: int = 1) -> Place:
        """Lines and columns count from 0 here, as in marks."""
        line = min(line, len(self.lines) - 1)
        return Place(self.path, line + 1, column + 1, max(1, length), self.lines[line])

    def at(self, index: int, length: int = 1) -> Place:
        line = bisect_right(self.starts, index) - 1
        return self.place(line, index - self.starts[line], length)

    def leave_out_odd_parts(self) -> list[Mistake]:
        """Note what YAML itself has no good sentence for, and put blanks in its place."""
        odd = _UNPRINTABLE.search(self.text)
        if odd is not None:
            raise refuse(
                self.at(odd.start()),
                "control-character",
                f"the character U+{ord(odd[0]):04X} may not stand in a scenario",
            )
        mistakes = []
        directive = _DIRECTIVE.search(self.text)
        if directive is not None:
            place = self.at(directive.start(), len(directive[0]))
            help = "remove the line; the format is always YAML 1.2"
            mistakes.append(Mistake(place, "directive", "a directive is not allowed", help))
            line = re.compile(r"^%.*", re.MULTILINE)
            self.text = line.sub(lambda match: "#" * len(match[0]), self.text)
        for match in _TAB.finditer(self.text):
            place = self.at(match.end() - len(match[0].lstrip(" ")))
            help = "indent with spaces"
            mistakes.append(Mistake(place, "tab", "a tab stands in the indentation", help))
        self.text = _TAB.sub(lambda match: match[0].replace("\t", " "), self.text)
        return mistakes

    def no_such_character(self) -> Mistake:
        """The mistake of an escape in double quotes beyond the last character of Unicode."""
        escape = _NO_CHARACTER.search(self.text)
        place = self.at(escape.start(), len(escape[0])) if escape else self.place(0, 0)
        return Mistake(place, "syntax", "this escape stands for no character")


class _Builder:
    """Makes nodes of the parser's events; what may not be there is noted on the way."""

    def __init__(self, text: _Text) -> None:
        self.text = text
        self.mistakes: list[Mistake] = []
        self.open: list[_Open] = []
        self.documents: list[Node] = []
        self.aliases: set[str] = set()
        """Those that were noted already: once each is enough."""
        self.takes_keys_from_elsewhere = False
        """Whether a mapping has a merge key, so that nobody knows which keys it lacks."""

    def document(self) -> Node:
        try:
            for event in YAML(typ="safe", pure=True).parse(self.text.text):
                self.take(event)
        except MarkedYAMLError as error:
            raise Refused(*self.mistakes, self.syntax(error)) from None
        except ValueError:
            raise Refused(*self.mistakes, self.text.no_such_character()) from None
        if self.takes_keys_from_elsewhere:
            raise Refused(*self.mistakes)
        root = self.documents[0] if self.documents else None
        if root is None or (isinstance(root, ScalarNode) and root.is_nothing):
            raise refuse(
                self.text.place(0, 0),
                "empty-file",
                "the file is empty",
                "'laws new inertia' writes a scenario to start from",
            )
        return root

    def take(self, event: Event) -> None:
        match event:
            case DocumentStartEvent() if self.documents:
                place = self.text.place(event.start_mark.line, event.start_mark.column, 3)
                help = "put each scenario into a file of its own"
                raise Refused(
                    *self.mistakes,
                    Mistake(place, "several-documents", "a second document starts here", help),
                )
            case AliasEvent():
                if event.anchor not in self.aliases:
                    self.aliases.add(event.anchor)
                    self.note(event, "alias", "an alias is not allowed")
                self.put(ScalarNode(self.place(event), "", plain=False))
            case ScalarEvent() | CollectionStartEvent():
                if event.anchor is not None:
                    self.note(event, "anchor", "an anchor is not allowed")
                self.node(event)
            case MappingEndEvent() | SequenceEndEvent():
                self.put(self.closed(self.open.pop(), event))
            case _:
                pass

    def node(self, event: ScalarEvent | CollectionStartEvent) -> None:
        """The start of a list or mapping, or a scalar."""
        if event.ctag is not None:
            self.note(event, "tag", "a tag is not allowed")
        if isinstance(event, ScalarEvent):
            self.put(ScalarNode(self.place(event), event.value, plain=event.style is None))
            return
        if len(self.open) == DEEPEST:
            raise Refused(
                *self.mistakes,
                Mistake(
                    self.place(event),
                    "too-deep",
                    f"lists and mappings are nested more than {DEEPEST} deep",
                ),
            )
        is_mapping = isinstance(event, MappingStartEvent)
        self.open.append(_Open(self.place(event), is_mapping, bool(event.flow_style)))

    def closed(self, opened: "_Open", end: Event) -> Node:
        place = opened.place
        if opened.is_flow and end.end_mark.line == place.line - 1:
            place = place._replace(length=end.end_mark.column + 1 - place.column)
        if not opened.is_mapping:
            return ListNode(place, tuple(opened.values))
        entries: dict[str, tuple[ScalarNode, Node]] = {}
        for key, value in zip(opened.values[::2], opened.values[1::2], strict=True):
            if not isinstance(key, ScalarNode):
                sentence = "a key must be a word, not a list or a mapping"
                self.mistakes.append(Mistake(key.place, "wrong-type", sentence))
            elif key.text in entries:
                first = entries[key.text][0].place
                self.mistakes.append(
                    Mistake(
                        key.place,
                        "duplicate-key",
                        f"the key {quote(key.text)} was given already in line {first.line}",
                    )
                )
            else:
                if isinstance(value, ScalarNode) and value.plain and not value.text:
                    value = value._replace(place=key.place)  # its own may be lines below
                entries[key.text] = (key, value)
        if self.aliases and "<<" in entries:
            self.takes_keys_from_elsewhere = True
        return MapNode(place, tuple(entries.values()))

    def put(self, node: Node) -> None:
        (self.open[-1].values if self.open else self.documents).append(node)

    def note(self, event: NodeEvent, code: str, sentence: str) -> None:
        place = self.place(event)
        word = _WORD.match(place.source, place.column - 1)
        place = place._replace(length=len(word[0]) if word else 1)
        self.mistakes.append(Mistake(place, code, sentence, "write the value out where it is used"))

    def place(self, event: Event) -> Place:
        start, end = event.start_mark, event.end_mark
        length = end.column - start.column
        place = self.text.place(start.line, start.column, length)
        if end.line != start.line:
            rest = len(place.source.rstrip()) - start.column
            return place._replace(length=max(1, rest))
        return place

    def syntax(self, error: MarkedYAMLError) -> Mistake:
        mark = error.problem_mark or error.context_mark
        if error.context_mark and _AT_THE_START.search(str(error.problem)):
            mark = error.context_mark
        place = self.text.place(mark.line, mark.column) if mark else self.text.place(0, 0)
        if place.source[place.column - 1 :].startswith("\t"):
            return Mistake(place, "tab", "a tab stands here", "use spaces")
        problem = str(error.problem or error.context)
        for told, sentence, help in _SYNTAX:
            if told in problem:
                return Mistake(place, "syntax", sentence, help)
        return Mistake(place, "syntax", f"this is not YAML: {visible(problem)}")


class _Open:
    """A list or mapping whose end is still to come."""

    def __init__(self, place: Place, is_mapping: bool, is_flow: bool) -> None:
        """`is_flow`: whether it is written in brackets."""
        self.place = place
        self.is_mapping = is_mapping
        self.is_flow = is_flow
        self.values: list[Node] = []


_WORD = re.compile(r"\S+")

_AT_THE_START = re.compile("could not find expected ':'|unexpected end of stream")
"""Problems that are found far behind the place where they can be mended."""

_SYNTAX = (
    (
        "mapping values are not allowed",
        "a ':' stands where no key can be",
        "put quotes around text that contains ': ', and check the indentation",
    ),
    (
        "expected ',' or",
        "a bracket or a comma is missing",
        "close every '[' with ']' and every '{' with '}'; put commas between",
    ),
    (
        "unexpected end of stream",
        "a quoted text does not end",
        "close it with the same quote",
    ),
    (
        "cannot start any token",
        "this character cannot start a value",
        "put quotes around the text",
    ),
    (
        "could not find expected ':'",
        "this line is neither a key with a ':' nor part of a value",
        "write 'key: value', or indent the line to continue the text above",
    ),
    (
        "expected <block end>",
        "this line does not fit the indentation of the lines above",
        "start it in the same column as its neighbours",
    ),
    (
        "expected '<document start>'",
        "this line does not fit the indentation of the lines above",
        "start it in the same column as its neighbours",
    ),
    (
        "unknown escape character",
        "a backslash in double quotes is followed by an unknown letter",
        "use single quotes, or write the backslash twice",
    ),
)
