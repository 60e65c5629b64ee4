"""Repeated sub-programs: those equal up to their leaves become one function that each calls.

Equal are the operations and their order, as printed; only the first two operands of a sum or of a product may change
places, which changes no rounding. What the names of the scene's parts say serves to name what was found, and to keep
together what is computed for one part. A function is made where it shortens the text.
"""

from __future__ import annotations

import keyword
import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum, auto
from functools import cached_property, lru_cache
from typing import Any

HOLE = "#"
_NAME = re.compile(r"(?<![\w.])[^\W\d]\w*\b(?!\.)")
_PRODUCT = re.compile(rf"(?:^|\(|, | [-+] )({HOLE})\*({HOLE})(?!\*\*|\[)")
_SUM = re.compile(rf"(?:^|\(|, )({HOLE}) \+ ({HOLE})(?=$|\)|,| [-+] )")
_TERMS = re.compile(rf"([\d{HOLE}*/]+) \+ ([\d{HOLE}*/]+)(?= [-+] |$)")
_FRAME = 6  # lines of a function beside its assignments
_CALL = 8  # names in a call that are as much to read as an assignment
_OF_PARTS = (
    20  # least lines saved by a function of what is connected by the name of a part alone: it is the harder to read
)
_TRIED = 8  # functions with which a sub-program is compared
_RANKS = ("first", "second", "third", "fourth", "fifth", "sixth")

_Pairs = list[tuple[int, int]]


@dataclass(frozen=True)
class Step:
    """Assignment of an expression, with a HOLE for each operand, or of what a shared function returns."""

    targets: tuple[str, ...]
    shape: str
    operands: tuple[str, ...]
    callee: Shared | None = None

    def text(self, names: Mapping[str, str]) -> str:
        """Right-hand side with other names for some operands."""
        texts = [names.get(operand, operand) for operand in self.operands]
        if self.callee is not None:
            return f"{self.callee.name}({', '.join(texts[k] for k in self.callee.order)})"
        first, *rest = self.shape.split(HOLE)
        return first + "".join(text + part for text, part in zip(texts, rest, strict=True))


def step_of(target: str, code: str, names: Iterable[str]) -> Step:
    """Step of the text of an expression of names."""
    operands: list[str] = []

    def hole(match: re.Match[str]) -> str:
        if match[0] not in names:
            return match[0]
        operands.append(match[0])
        return HOLE

    shape = _NAME.sub(hole, code)
    return Step((target,), shape, tuple(operands))


@dataclass
class Block:
    """Code of a builder: steps in order; of each entry of its results the owner and the names read."""

    name: str
    arguments: tuple[str, ...]
    steps: list[Step]
    results: Sequence[tuple[str, Sequence[str]]]
    inputs: Mapping[str, str]
    """Name of an input -> where it stands, `q[3]`."""

    @cached_property
    def place(self) -> dict[str, int]:
        """Place of each name among the steps at first."""
        return {target: i for i, step in enumerate(self.steps) for target in step.targets}

    def order(self, name: str) -> tuple[int, int]:
        """Key of the order in which a reader expects names: what is made, then inputs, constants last."""
        if name in self.place:
            return 0, self.place[name]
        place = [*self.inputs].index(name) if name in self.inputs else -1
        return 2 if self.inputs.get(name, "").startswith("c") else 1, place


@dataclass
class _Parts:
    """Names of the scene's parts with their kinds, and names split by them."""

    kinds: Mapping[str, str]
    known: dict[str, tuple[list[str], list[str]]] = field(default_factory=dict)

    def split(self, name: str) -> tuple[list[str], list[str]]:
        """Words of a name that are no part of the scene, and those parts."""
        if name not in self.known:
            words, rest, parts, begin = name.split("_"), [], [], 0
            while begin < len(words):
                ends = range(len(words), begin, -1)
                end = next((end for end in ends if "_".join(words[begin:end]) in self.kinds), None)
                if end is None:
                    rest.append(words[begin])
                else:
                    parts.append("_".join(words[begin:end]))
                begin = end or begin + 1
            self.known[name] = rest, parts
        return self.known[name]


@dataclass
class Shared:
    """A function that several blocks call: parameters, steps, names it returns."""

    form: _Form
    name: str = ""
    parameters: tuple[str, ...] = ()
    steps: tuple[Step, ...] = ()
    returns: tuple[str, ...] = ()
    order: Sequence[int] = ()
    """Place of each parameter among the leaves."""
    sites: list[_Site] = field(default_factory=list)

    @cached_property
    def places(self) -> dict[str, list[int]]:
        """Steps of each shape, in order at the first site."""
        first, places = self.sites[0], defaultdict(list)
        for k in sorted(range(len(first.steps)), key=lambda k: first.block.place[first.steps[k]]):
            places[self.form.shapes[k]].append(k)
        return places

    def units(self, known: Mapping[str, str]) -> list[str]:
        """Unit of each name it returns, "" where names have none."""
        return [known.get(self.sites[0].steps[root], "") for root in self.form.roots]


@dataclass(frozen=True)
class _Form:
    """Sub-program without names: shapes and operands of its steps from the roots down.

    An operand is a step's number, or -1 - k for leaf k.
    """

    roots: tuple[int, ...]
    shapes: tuple[str, ...]
    operands: tuple[tuple[int, ...], ...]
    leaves: int

    @property
    def key(self) -> tuple[str, ...]:
        return tuple(self.shapes[root] for root in self.roots)

    def saves(self, count: int) -> int:
        """Lines saved by a function called `count` times."""
        call = 1 + (self.leaves + len(self.roots)) // _CALL
        return count * (len(self.shapes) - call) - len(self.shapes) - _FRAME


@dataclass(frozen=True)
class _Site:
    """Where a form occurs: its steps and leaves, by name, in the form's order."""

    block: Block
    steps: tuple[str, ...]
    leaves: tuple[str, ...]

    def common_part(self, steps: _Pairs, leaves: _Pairs, side: int) -> _Site:
        """Site of the part that is common with another form."""
        ends = [leaf[side] for leaf in leaves]
        names = tuple(self.steps[end] if end >= 0 else self.leaves[-1 - end] for end in ends)
        return _Site(self.block, tuple(self.steps[pair[side]] for pair in steps), names)


class _Cut(Enum):
    """Where a group ends beside other owners and calls.

    NOWHERE; where others READ a step; at a step named for another PART, as the links of a chain, which serve the same
    results.
    """

    NOWHERE = auto()
    READ = auto()
    PART = auto()


@dataclass(frozen=True)
class _Group:
    """Assignments for which calls may stand: shape and operands of each, and those that others read."""

    block: Block
    codes: Mapping[int, tuple[str, list[int | str]]]
    roots: list[int]
    reads: Mapping[str, int]
    """How often each name of the block is read."""

    @cached_property
    def places(self) -> dict[str, list[int]]:
        """Steps of each shape, in order."""
        places: dict[str, list[int]] = defaultdict(list)
        for i, (shape, _) in self.codes.items():
            places[shape].append(i)
        return places

    def below(self, roots: list[int]) -> tuple[_Form, _Site]:
        """Form and site of all that some steps need within the group."""
        numbers: dict[int, int] = {}
        leaves: dict[str, int] = {}
        pending = roots[::-1]
        while pending:
            i = pending.pop()
            if i not in numbers:
                numbers[i] = len(numbers)
                pending += [j for j in reversed(self.codes[i][1]) if isinstance(j, int)]
        operands = tuple(
            tuple(
                numbers[j] if isinstance(j, int) else -1 - leaves.setdefault(j, len(leaves)) for j in self.codes[i][1]
            )
            for i in numbers
        )
        names = tuple(self.block.steps[i].targets[0] for i in numbers)
        form = _Form(tuple(numbers[r] for r in roots), tuple(self.codes[i][0] for i in numbers), operands, len(leaves))
        return form, _Site(self.block, names, tuple(leaves))


def share(blocks: Sequence[Block], kinds: Mapping[str, str], taken: set[str]) -> list[Shared]:
    """Replace repeated sub-programs of blocks by calls of functions, which it returns.

    `kinds` are those of the scene's parts, by name; `taken` are names that no function may have.
    """
    parts = _Parts(kinds)
    functions: list[Shared] = []
    for cut in _Cut:  # whole groups first: fewer functions, with more in each
        groups = {block.name: list(_groups(block, parts, cut)) for block in blocks}
        known, least = (functions, 1) if cut is not _Cut.PART else ([], _OF_PARTS)
        while changed := _share_once([group for of in groups.values() for group in of], known, least):
            groups |= {block.name: list(_groups(block, parts, cut)) for block in changed}
        functions += known if known is not functions else []
    for shared in functions:
        _name(shared, parts, taken)
    return functions


def _share_once(groups: Iterable[_Group], functions: list[Shared], least: int) -> list[Block]:
    """Replace repeated sub-programs by calls that save at least so many lines; return the changed blocks."""
    alike: dict[_Form, list[_Site]] = {}
    joined: list[tuple[Shared, _Site]] = []
    for group in groups:
        again = next(((shared, site) for shared in functions if (site := _site_in(group, shared))), None)
        if again:
            again[0].sites.append(again[1])
            joined.append(again)
        else:
            form, site = group.below(group.roots)
            alike.setdefault(form, []).append(site)
    kinds: dict[tuple[str, ...], list[Shared]] = defaultdict(list)
    for form, sites in sorted(alike.items(), key=lambda item: -len(item[1]) * len(item[0].shapes)):
        _join(form, sites, kinds[form.key])
    new = [shared for kind in kinds.values() for shared in kind if shared.form.saves(len(shared.sites)) >= least]
    functions += new
    joined += [(shared, site) for shared in new for site in shared.sites]
    calls: dict[int, list[Step]] = defaultdict(list)
    gone: dict[int, set[str]] = defaultdict(set)
    changed = {id(site.block): site.block for _, site in joined}
    for shared, site in joined:
        returned = tuple(site.steps[root] for root in shared.form.roots)
        calls[id(site.block)].append(Step(returned, "", site.leaves, shared))
        gone[id(site.block)].update(site.steps)
    for key, block in changed.items():
        left = [step for step in block.steps if step.callee or step.targets[0] not in gone[key]]
        block.steps = _sorted(left + calls[key], block.place)
    return list(changed.values())


def _site_in(group: _Group, shared: Shared) -> _Site | None:
    """Site within a group of a function found before, if all of it is there and serves nothing else."""
    form, there = shared.form, shared.places
    if any(len(group.places.get(shape, ())) != len(there[shape]) for shape in form.key):
        return None
    roots = [group.places[shape][there[shape].index(root)] for root, shape in zip(form.roots, form.key, strict=True)]
    here, whole = group.below(roots)
    common = _common(form, here)
    if common is None or len(common[0].shapes) < len(form.shapes) or common[0].leaves > form.leaves:
        return None
    site = whole.common_part(*common[1:], 1)
    read = Counter(operand for operands in form.operands for operand in operands)
    inner = (k for k in range(len(form.shapes)) if k not in form.roots)
    return site if all(read[k] == group.reads[site.steps[k]] for k in inner) else None


def _join(form: _Form, sites: list[_Site], kinds: list[Shared]) -> None:
    """Add sites to the function of which most is common with them, else make one of their own."""
    best, most = None, 0
    alone = max(form.saves(len(sites)), 0)
    for shared in kinds[:_TRIED]:
        common = _common(shared.form, form)
        if common is None:
            continue
        now = max(shared.form.saves(len(shared.sites)), 0) + alone
        gain = common[0].saves(len(shared.sites) + len(sites)) - now
        if gain > most:
            best, most = (shared, common), gain
    if best is None:
        kinds.append(Shared(form, sites=list(sites)))
        return
    shared, (shared.form, pairs, leaves) = best
    for side, of in ((0, shared.sites), (1, sites)):
        of[:] = [site.common_part(pairs, leaves, side) for site in of]
    shared.sites += sites


def _common(one: _Form, other: _Form) -> tuple[_Form, _Pairs, _Pairs] | None:
    """Largest common part from the roots down, with its steps and leaves in both; None if there is none.

    A step stays outside where it is needed twice, or by what is outside.
    """
    outside: set[tuple[int, int]] = set()
    roots = list(zip(one.roots, other.roots, strict=True))
    while True:
        steps: dict[tuple[int, int], int] = {}
        pending = roots[::-1]
        below: dict[tuple[int, int], list[tuple[int, int]]] = {}
        while pending:
            pair = pending.pop()
            if pair not in steps:
                steps[pair] = len(steps)
                below[pair] = list(zip(one.operands[pair[0]], other.operands[pair[1]], strict=True))
                pending += [
                    (a, b)
                    for a, b in reversed(below[pair])
                    if min(a, b) >= 0 and one.shapes[a] == other.shapes[b] and (a, b) not in outside
                ]
        leaves: dict[tuple[int, int], int] = {}
        operands = tuple(
            tuple(steps[p] if p in steps else -1 - leaves.setdefault(p, len(leaves)) for p in below[pair])
            for pair in steps
        )
        clashing = _clashing(one, steps, leaves, 0) | _clashing(other, steps, leaves, 1)
        if not clashing:
            form = _Form(tuple(steps[r] for r in roots), tuple(one.shapes[a] for a, _ in steps), operands, len(leaves))
            return form, list(steps), list(leaves)
        if clashing.intersection(roots):
            return None
        outside |= clashing


def _clashing(
    form: _Form, steps: Iterable[tuple[int, int]], leaves: Iterable[tuple[int, int]], side: int
) -> set[tuple[int, int]]:
    """Pairs whose step of one side is in another pair as well, or needed by a leaf."""
    count: dict[int, int] = defaultdict(int)
    for pair in steps:
        count[pair[side]] += 1
    outer: set[int] = set()
    pending = [leaf[side] for leaf in leaves if leaf[side] >= 0]
    while pending:
        step = pending.pop()
        if step not in outer:
            outer.add(step)
            pending += [operand for operand in form.operands[step] if operand >= 0]
    return {pair for pair in steps if count[pair[side]] > 1 or pair[side] in outer}


def _groups(block: Block, parts: _Parts, cut: _Cut) -> Iterable[_Group]:
    """Yield groups of assignments of the same owners, connected or named for the same part.

    What lies between two steps of a group serves the same owners, and is on the same level, for which a call and
    a `cut` end one: it is in the group, and a call may stand for it.
    """
    steps = block.steps
    maker = {target: i for i, step in enumerate(steps) for target in step.targets}
    bits: dict[str, int] = {}
    serves = [[0, 0] for _ in steps]  # parts of the scene; others, such as the kinetic energy
    roots: set[int] = set()
    for owner, names in block.results:
        bit = bits.setdefault(owner, 1 << len(bits))
        for made in (maker[name] for name in names if name in maker):
            serves[made][owner not in parts.kinds] |= bit
            roots.add(made)
    operands = [[maker[name] for name in step.operands if name in maker] for step in steps]
    for i in reversed(range(len(steps))):
        for j in operands[i]:
            serves[j] = [a | b for a, b in zip(serves[j], serves[i], strict=True)]
    owners = [(ours or -others) for ours, others in serves]
    outer = roots.union(j for i, of in enumerate(operands) for j in of if owners[i] != owners[j] or steps[i].callee)
    named = [tuple(parts.split(step.targets[0])[1]) for step in steps]
    part = named if cut is _Cut.PART else [()] * len(steps)
    level = [0] * len(steps)
    for i, step in enumerate(steps):
        ends = step.callee is not None
        same = [j for j in operands[i] if owners[j] == owners[i]]
        level[i] = max(
            (level[j] + (ends or part[j] != part[i] or (cut is _Cut.READ and j in outer)) for j in same), default=0
        )
    whose = list(zip(owners, level, part, strict=True))
    group = list(range(len(steps)))

    def head(i: int) -> int:
        while group[i] != i:
            group[i] = i = group[group[i]]
        return i

    for i, step in enumerate(steps):
        for j in operands[i]:
            if not step.callee and not steps[j].callee and whose[i] == whose[j]:
                group[head(j)] = head(i)
            else:
                roots.add(j)
    beside: dict[tuple[Any, ...], int] = {}
    members: dict[int, list[int]] = defaultdict(list)
    for i, step in enumerate(steps):
        if not step.callee and named[i]:
            group[head(i)] = head(beside.setdefault((whose[i], *named[i]), i))
    for i, step in enumerate(steps):
        if not step.callee:
            members[head(i)].append(i)
    ranks = {name: place[0] for name, place in block.inputs.items()}
    ranks |= {target: f"~{step.shape}" for step in steps for target in step.targets}
    reads = Counter(
        name for names in (*(step.operands for step in steps), *(of for _, of in block.results)) for name in names
    )
    for group_members in members.values():
        if len(group_members) > 1:
            inside = set(group_members)
            codes = {}
            for i in group_members:
                shape, order = _commuted(steps[i].shape, tuple(ranks.get(name, "") for name in steps[i].operands))
                names = [steps[i].operands[k] for k in order]
                codes[i] = shape, [maker[name] if maker.get(name) in inside else name for name in names]
            yield _Group(block, codes, [i for i in group_members if i in roots], reads)


@lru_cache(maxsize=4096)
def _commuted(shape: str, ranks: tuple[str, ...]) -> tuple[str, list[int]]:
    """Shape and order of operands that do not depend on names, as some may change places."""
    order = list(range(len(ranks)))
    for match in (*_PRODUCT.finditer(shape), *_SUM.finditer(shape)):
        k = shape.count(HOLE, 0, match.start(1))
        if ranks[k + 1] < ranks[k]:
            order[k : k + 2] = k + 1, k
    if terms := _TERMS.match(shape):
        first, second = terms.groups()
        end = first.count(HOLE)
        both = end + second.count(HOLE)
        if second < first:
            return f"{second} + {first}{shape[terms.end() :]}", order[end:both] + order[:end] + order[both:]
    return shape, order


def _sorted(steps: list[Step], place: Mapping[str, int]) -> list[Step]:
    """Steps after what they read, else in their order at first."""
    maker = {target: step for step in steps for target in step.targets}
    done: dict[str, Step] = {}
    for step in sorted(steps, key=lambda step: max(place[target] for target in step.targets)):
        pending = [step]
        while pending:
            needed = [maker[name] for name in pending[-1].operands if name in maker]
            needed = [read for read in needed if read.targets[0] not in done]
            if needed:
                pending += needed
            else:
                last = pending.pop()
                done[last.targets[0]] = last
    return list(done.values())


def _name(shared: Shared, parts: _Parts, taken: set[str]) -> None:
    """Name a function, its parameters and its steps by what names at its sites have in common."""
    form, first = shared.form, shared.sites[0]
    count = len(form.shapes)
    here = (*first.steps, *first.leaves)
    roles = [_role(names, parts) for names in zip(*((*site.steps, *site.leaves) for site in shared.sites), strict=True)]
    alike: dict[str, list[int]] = defaultdict(list)
    for k in sorted(range(len(here)), key=lambda k: first.block.order(here[k])):
        alike[roles[k]].append(k)
    names, used = [""] * len(here), {word for shape in form.shapes for word in _NAME.findall(shape)}
    for role, places in alike.items():
        ranks = (f"{rank}_" for rank in _RANKS) if 1 < len(places) <= len(_RANKS) else [""] * len(places)
        for k, rank in zip(places, ranks, strict=False):
            names[k] = _free(f"{rank}{role}", used)
    shared.order = sorted(range(form.leaves), key=lambda k: first.block.order(first.leaves[k]))
    shared.parameters = tuple(names[count + k] for k in shared.order)
    shared.returns = tuple(names[root] for root in form.roots)
    shared.steps = tuple(
        Step((names[k],), form.shapes[k], tuple(names[i if i >= 0 else count - 1 - i] for i in form.operands[k]))
        for k in sorted(range(count), key=lambda k: first.block.order(here[k]))
    )
    kinds = [parts.kinds[part] for part in parts.split(here[form.roots[0]])[1]]
    words = [*filter(str.isidentifier, kinds[:1]), *_purpose([roles[root] for root in form.roots], first, parts)]
    shared.name = _free("_".join(words), taken)


def _purpose(returned: list[str], site: _Site, parts: _Parts) -> list[str]:
    """Words common to all that a function returns, else words of the builder it serves."""
    first, *others = (name.split("_") for name in returned)
    common = [word for word in first if word.isidentifier() and all(word in other for other in others)]
    result = any(site.steps[0] in names for _, names in site.block.results)
    return common or [*parts.split(site.block.name)[0], *([] if result else ["terms"])]


def _role(names: Sequence[str], parts: _Parts) -> str:
    """Words that names have in common beside those of the scene's parts, and beside ranks."""
    first, *others = (parts.split(name)[0] for name in dict.fromkeys(names))
    common = [word for word in first if all(word in other for other in others)] or first
    text = "_".join([word for word in common if word not in _RANKS] or common)
    return text if text.isidentifier() else f"value_{text}".rstrip("_")


def _free(name: str, taken: set[str]) -> str:
    """The name, numbered where it is taken; it is taken from then on."""
    number, free = 1, name
    while free in taken or keyword.iskeyword(free):
        number += 1
        free = f"{name}_{number}"
    taken.add(free)
    return free
