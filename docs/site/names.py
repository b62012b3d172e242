"""The index of every public name: what the headers declare outside of graze::detail, with the comments that stand there."""
import re
from pathlib import Path

KINDS = (
    (r'\bconcept\s+(\w+)\s*=', 'concept'),
    (r'\busing\s+(\w+)\s*=', 'type'),
    (r'\benum\s+class\s+(\w+)', 'enumeration'),
    (r'\b(?:struct|class)\s+(?:\[\[[^\]]*\]\]\s*)?(\w+)', 'type'),
    (r'\b(operator\s*(?:<=>|==|[-+*/<>]=?))\s*\(', 'operator'),
    (r'\b(\w+)\s*\(', 'function'),
    (r'\bconstexpr\s+[\w:<>, ]+?\b(\w+)(?:<[^=]*>)?\s*(?:=|\{|;)', 'constant'),
)
NO_NAMES = {'requires', 'decltype', 'static_assert', 'noexcept', 'sizeof', 'alignas', 'if', 'for', 'while', 'return', 'defined', 'graze'}


def declared(code):
    """Name and kind of what a declaration declares; None if it declares nothing new."""
    code = re.sub(r'\[\[[^\]]*\]\]', ' ', code)
    code = re.sub(r'\brequires\s*\([^{;]*?\)\s*(?=\n|struct|class|\[|constexpr|inline)', ' ', code)
    head = re.sub(r'^\s*template\s*<(?:[^<>]|<(?:[^<>]|<(?:[^<>]|<[^<>]*>)*>)*>)*>\s*', '', code).strip()
    if head.startswith(('friend', 'extern', 'static_assert', 'namespace', 'using namespace')):
        return None
    for pattern, kind in KINDS:
        for match in re.finditer(pattern, head):
            if match[1] not in NO_NAMES:
                return match[1].replace(' ', ''), kind
    return None


def declarations(text):
    """(name, kind, comment, declaration) of all that a header declares in graze and not in graze::detail. What stands in a
    namespace of graze has its name before its own: batch::classify."""
    if '#pragma once' not in text:
        return
    hidden = 0  # depth of a namespace detail
    depth = 0  # of braces within graze
    spaces = []  # within graze, an inline one as ''
    comment, code, group = [], [], []
    for line in text.split('\n'):
        bare = re.sub(r'//.*', '', line)
        opened = re.match(r'namespace graze::inline \w+((?:::\w+)*) \{', line)
        if opened and 'detail' not in opened[1]:
            depth, hidden = 0, 0
            spaces = [s for s in opened[1].split('::') if s]
            continue
        if re.match(r'namespace \w*(::\w+)*detail \{|namespace graze::inline \w+::detail \{', line):
            hidden = 1
            continue
        if re.match(r'\} // namespace .*detail$', line):
            hidden = 0
            continue
        inner = re.match(r'(inline )?namespace (\w+) \{$', line)
        if inner and not hidden and depth == 0:
            spaces.append('' if inner[1] else inner[2])
            comment = []
            continue
        closed = re.match(r'\} // namespace (\w+)$', line)
        if closed and not hidden and spaces:
            spaces.pop()
            continue
        if hidden or line.startswith(('#', '}')) and depth == 0 and not code:
            continue
        if depth == 0 and not code:
            if line.startswith('//'):
                comment.append(line[2:].removeprefix(' '))
                continue
            if not line.strip():
                comment, group = [], []
                continue
        code.append(line)
        depth += bare.count('{') - bare.count('}')
        if depth == 0 and re.search(r'[;}]\s*$', bare):
            whole = '\n'.join(code)
            shown = whole if re.match(r'(template.*\n)?(enum|using|concept)', whole) or len(code) <= 14 else whole.split('{')[0]
            found = declared(whole.split('{')[0] if '=' not in whole.split('{')[0] else whole.split('\n\n')[0])
            if found:
                name, kind = found
                yield '::'.join([*filter(None, spaces), name]), kind, comment or group, shown.rstrip()
            group = comment or group
            comment, code = [], []


def page(include):
    """The page, in Markdown."""
    found = {}
    for header in sorted(Path(include).rglob('*.hpp')):
        for name, kind, comment, code in declarations(header.read_text()):
            found.setdefault(name, []).append((kind, header.relative_to(include), comment, code))
    lines = ['# Index of names', '', 'Every public declaration, as it stands in its header: what it computes, shapes and units, range, errors and source.',
             'Written by `docs/site/names.py`.', '']
    letters = sorted({name[0].lower() for name in found if name[0].isalpha()})
    for letter in [*letters, '=']:
        names = sorted(n for n in found if (n[0].lower() == letter if letter != '=' else n.startswith('operator')))
        names = [n for n in names if letter == '=' or not n.startswith('operator')]
        if not names:
            continue
        lines += [f'## {"Operators" if letter == "=" else letter.upper()}', '']
        for name in names:
            lines += [f'### `{name}`', '']
            for kind, header, comment, code in found[name]:
                lines += [f'A {kind} of `{header}`.', '', '```c++', *['// ' + c if c else '//' for c in comment], code, '```', '']
    return '\n'.join(lines), found
