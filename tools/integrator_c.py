"""Integrator and estimator as C: `integrator.py` and its kin, written in a small part of Python, translated.

Types of the fields of their tuples and of their arguments stand in the tables below; those of variables and results
follow. What is not known stops with the line that has it. Needs neither numba nor a compiler.
"""

from __future__ import annotations

import ast
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

ENGINE = Path(__file__).parents[1] / "src" / "poppet" / "engine"
FIELDS: dict[str, dict[str, str]] = {
    "Functions": dict.fromkeys(("jacobian", "step", "dense", "outputs", "update"), "int"),
    "Memory": {"p": "vector", "z": "vector", "acting": "flags", "fired": "vector", "after": "vector"},
    "Control": {
        "tolerances": "matrix", "positive": "flags", "longest": "double", "most": "double", "script": "vector",
        "replays": "bool",
    },
    "OutputRows": {"grid": "vector", "table": "matrix", "y": "vector"},
    "Stops": {"places": "integer_matrix", "weights": "matrix"},
    "Work": dict.fromkeys(
        ("u", "us", "slopes", "tt", "rates", "jacobian", "drift", "scratch", "stages", "estimate", "new", "dense",
         "inside"), "vector",
    ),
    "RunState": {
        "functions": "Functions", "memory": "Memory", "control": "Control", "rows": "OutputRows", "stops": "Stops",
        "work": "Work", "x": "vector", "books": "vector", "watch": "vector", "counts": "integers",
    },
    "Segment": {"start": "double", "stop": "double", "inputs": "matrix"},
    "Step": {"t": "double", "h": "double", "end": "double", "new": "vector"},
    "Scratch": {
        **dict.fromkeys(("by_state", "by_free"), "matrix"), "by_touched": "vector",
        **dict.fromkeys(("start_system", "linear_system", "product", "other"), "matrix"),
        **dict.fromkeys(("y", "forecast", "y_by_state", "y_by_touched"), "vector"),
        **dict.fromkeys(("slopes", "gains", "steps"), "matrix"),
        **dict.fromkeys(
            ("effects", "variances", "sequence", "moved", "correction", "shift", "gain", "image"), "vector"
        ),
        "course": "matrix",
        **dict.fromkeys(("kept", "before"), "vector"),
    },
    "Estimator": {
        "linear": "int", "observe": "int", "clock": "vector", "mean": "vector", "covariance": "matrix", "u": "matrix",
        "places": "integers", "touched_inputs": "integers", "base": "vector", "directions": "matrix",
        **dict.fromkeys(("reference", "low", "high"), "vector"), "effects": "matrix",
        **dict.fromkeys(("readings", "noise", "gates", "walk", "cap", "expected", "innovations", "deviations", "used",
                         "rejected", "outside", "scores"), "vector"),
        **dict.fromkeys(("transition", "signatures", "numerators", "gram"), "matrix"), "scratch": "Scratch",
    },
}  # fmt: skip
"""Types of the fields of the tuples."""
BY_VALUE = ("Segment", "Step")
"""Tuples that are handed over as they are; of the others the address."""
ARGUMENTS = {
    "run": "RunState", "segment": "Segment", "step": "Step", "memory": "Memory", "control": "Control", "job": "Job",
    "scales": "matrix", "x": "vector", "u": "vector", "slopes": "vector", "new": "vector", "c": "vector",
    "script": "vector", "lands": "bool", "has_acted": "bool", "est": "Estimator", "estimator_job": "EstimatorJob",
    "mean": "vector", "system": "matrix", "derivatives": "matrix", "limits": "vector", "node": "int", "k": "int",
    "n": "int",
}  # fmt: skip
"""Types of arguments by name; all others are numbers."""
OF_ONE_FUNCTION = {("_again", "step"): "int", ("_use_reading", "c"): "int"}
JOBS = {"Job": "job", "EstimatorJob": "estimator_job"}
"""Rows of fields, and the files that have them."""
ELEMENTS = {"vector": "double", "integers": "int", "flags": "bool", "matrix": "double", "integer_matrix": "int"}
C_TYPES = {"double": "double", "int": "int64_t", "bool": "int"}
KERNEL = {
    "jacobian": "t x u slopes p -> f J drift",
    "step": "th x us p f J drift w -> k x1",
    "dense": "k -> d",
    "outputs": "t x u p -> y",
    "update": "t x u p fired -> z",
    "linear": "t x u p -> A B",
    "observe": "t x u p -> y Hx Ht",
}
"""The functions of a model that a job has, as `poppet.engine.printers` gives them; `w` is scratch of a step."""


class Program(NamedTuple):
    """A function that others call, with all that it needs."""

    entry: str
    files: tuple[str, ...]
    jobs: tuple[str, ...]
    about: str


INTEGRATOR = Program(
    "integrate",
    ("rosenbrock", "stepping", "integrator"),
    ("Job",),
    """/* The adaptive integrator, translated from Python (tools/integrator_c.py); change it there.

   `integrate` takes one row of 64 bit numbers, addresses of functions and arrays and their lengths, and gives back how
   the run ended: 0 done, 1 stopped by a condition, 2 stalled, 3 too many attempts, 4 not finite, 5 interrupted.
   It allocates nothing, calls itself nowhere and keeps nothing. Not for -ffast-math: it asks what is finite. */""",
)
ESTIMATOR = Program(
    "estimate",
    ("rosenbrock", "stepping", "integrator", "estimator_job", "estimator"),
    ("Job", "EstimatorJob"),
    """/* The estimator, an extended Kalman filter, translated from Python (tools/integrator_c.py); change it there.

   `estimate` takes one row of 64 bit numbers, addresses of functions and arrays and their lengths, and gives back how
   the update ended: 0 done, 2 stalled, 3 too many attempts, 4 not finite. It allocates nothing.
   Not for -ffast-math: it asks what is finite. */""",
)
OPERATORS = {
    ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Mod: "%", ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">",
    ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!=", ast.And: "&&", ast.BitAnd: "&", ast.Or: "||",
}  # fmt: skip
VIEWS = """
typedef struct { double *at; int64_t size; } vector;
typedef struct { int64_t *at; int64_t size; } integers;
typedef struct { uint8_t *at; int64_t size; } flags;
typedef struct { double *at; int64_t rows, columns; } matrix;
typedef struct { int64_t *at; int64_t rows, columns; } integer_matrix;
typedef struct { double *at; int64_t sets, rows, columns; } cube;

static vector vector_at(int64_t address, int64_t size) {
  vector made;
  made.at = (double *)(intptr_t)address;
  made.size = size;
  return made;
}

static integers integers_at(int64_t address, int64_t size) {
  integers made;
  made.at = (int64_t *)(intptr_t)address;
  made.size = size;
  return made;
}

static flags flags_at(int64_t address, int64_t size) {
  flags made;
  made.at = (uint8_t *)(intptr_t)address;
  made.size = size;
  return made;
}

static matrix matrix_at(int64_t address, int64_t rows, int64_t columns) {
  matrix made;
  made.at = (double *)(intptr_t)address;
  made.rows = rows;
  made.columns = columns;
  return made;
}

static integer_matrix integer_matrix_at(int64_t address, int64_t rows, int64_t columns) {
  integer_matrix made;
  made.at = (int64_t *)(intptr_t)address;
  made.rows = rows;
  made.columns = columns;
  return made;
}

static cube cube_at(int64_t address, int64_t sets, int64_t rows, int64_t columns) {
  cube made;
  made.at = (double *)(intptr_t)address;
  made.sets = sets;
  made.rows = rows;
  made.columns = columns;
  return made;
}

static vector part_of(vector all, int64_t first, int64_t behind) {
  vector made;
  made.at = all.at + first;
  made.size = behind - first;
  return made;
}

static vector row_of(matrix all, int64_t row) {
  vector made;
  made.at = all.at + row * all.columns;
  made.size = all.columns;
  return made;
}

static matrix set_of(cube all, int64_t set) {
  matrix made;
  made.at = all.at + set * all.rows * all.columns;
  made.rows = all.rows;
  made.columns = all.columns;
  return made;
}

static double least(double a, double b) { return b < a ? b : a; }

static double most(double a, double b) { return b > a ? b : a; }

static int64_t least_integer(int64_t a, int64_t b) { return b < a ? b : a; }

static int is_finite(double a) { return a - a == 0.0; }
"""
"""What the rest needs: views of memory that somebody else owns, and what `math.h` of C90 has not."""


@dataclass
class Source:
    """Functions and constants of the files, and which of them have been asked for."""

    functions: dict[str, ast.FunctionDef] = field(default_factory=dict)
    constants: dict[str, object] = field(default_factory=dict)
    results: dict[str, tuple[str, ...]] = field(default_factory=dict)
    used: dict[str, object] = field(default_factory=dict)
    called: set[str] = field(default_factory=set)
    texts: list[str] = field(default_factory=list)

    def read(self, path: Path) -> None:
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.FunctionDef):
                self.functions[node.name] = node
            elif isinstance(node, ast.Assign):
                self._constants(node)

    def _constants(self, node: ast.Assign) -> None:
        target, value = node.targets[0], node.value
        try:
            found = ast.literal_eval(value)
        except ValueError:
            is_range = isinstance(value, ast.Call) and ast.unparse(value.func) == "range"
            if not is_range:
                return
            assert isinstance(value, ast.Call)
            found = tuple(range(int(ast.unparse(value.args[0]))))
        if isinstance(target, ast.Tuple):
            names = [name.id for name in target.elts if isinstance(name, ast.Name)]
            self.constants |= dict(zip(names, found, strict=False))
        elif isinstance(target, ast.Name):
            self.constants[target.id] = found

    def results_of(self, name: str) -> tuple[str, ...]:
        """Types of the results of a function, which is translated when it is asked for first."""
        if name not in self.results:
            Function(self, self.functions[name]).translate()
        return self.results[name]


@dataclass
class Value:
    """An expression of C: its text, its type, and whether it is the address of a tuple."""

    text: str
    kind: str
    is_address: bool = False


class Function:
    """One function on its way into C."""

    def __init__(self, source: Source, node: ast.FunctionDef) -> None:
        self.source, self.node, self.depth = source, node, 1
        self.lines: list[str] = []
        self.arguments = [argument.arg for argument in node.args.args]
        self.kinds = {a: OF_ONE_FUNCTION.get((node.name, a), ARGUMENTS.get(a, "double")) for a in self.arguments}
        self.addresses = {a for a in self.arguments if self.is_shared(self.kinds[a])}
        self.locals: dict[str, str] = {}
        self.results: tuple[str, ...] = ()

    @staticmethod
    def is_shared(kind: str) -> bool:
        return kind in JOBS or (kind in FIELDS and kind not in BY_VALUE)

    def translate(self) -> None:
        body = self.node.body
        doc = ast.get_docstring(self.node) or ""
        for statement in body[1:] if doc else body:
            self.statement(statement)
        name = self.node.name
        self.source.results[name] = self.results
        single = self.results[0] if len(self.results) == 1 else ""
        formal = [self.formal(a) for a in self.arguments]
        formal += [f"{C_TYPES[kind]} *r{k}" for k, kind in enumerate(self.results) if not single]
        is_entry = self.arguments == ["fields"]
        if is_entry:
            formal = ["const int64_t *fields"]
        head = f"{C_TYPES.get(single, single) or 'void'} {c_name(name)}({', '.join(formal)}) {{"
        declared = [f"  {declaration(kind, n, n in self.addresses)};" for n, kind in self.locals.items()]
        static = "" if is_entry else "static "
        comment = textwrap.fill(" ".join(doc.replace("`", "").split()), 116, subsequent_indent="   ")
        self.source.texts.append("\n".join([f"/* {comment} */", static + head, *declared, *self.lines, "}"]))

    def formal(self, name: str) -> str:
        return declaration(self.kinds[name], name, name in self.addresses, is_argument=True)

    def emit(self, text: str) -> None:
        self.lines.append("  " * self.depth + text)

    # Statements

    def statement(self, node: ast.stmt) -> None:
        match node:
            case ast.Assign():
                self.assign(node)
            case ast.AugAssign():
                left, right = self.value(node.target), self.value(node.value)
                self.emit(f"{left.text} {OPERATORS[type(node.op)]}= {right.text};")
            case ast.Expr(value=ast.Call() as call):
                self.emit(f"{self.call(call).text};")
            case ast.If():
                self.branch(node)
            case ast.While():
                self.loop(f"while ({bare(self.condition(node.test))}) {{", node.body)
            case ast.For(target=ast.Name(id=name), iter=ast.Call(args=[*first, ast.expr() as stop])):
                self.declare(name, "int")
                begin = bare(self.value(first[0]).text) if first else "0"
                self.loop(f"for ({name} = {begin}; {name} < {self.value(stop).text}; {name}++) {{", node.body)
            case ast.Return():
                self.give_back(node)
            case ast.Break():
                self.emit("break;")
            case ast.Continue():
                self.emit("continue;")
            case _:
                raise NotImplementedError(f"{self.node.name}:{node.lineno}: {ast.unparse(node)}")

    def loop(self, head: str, body: list[ast.stmt]) -> None:
        self.emit("for (;;) {" if head == "while (1) {" else head)
        self.depth += 1
        for each in body:
            self.statement(each)
        self.depth -= 1
        self.emit("}")

    def branch(self, node: ast.If) -> None:
        self.loop(f"if ({bare(self.condition(node.test))}) {{", node.body)
        if len(node.orelse) == 1 and isinstance(node.orelse[0], ast.If):
            head = len(self.lines) - 1
            self.branch(node.orelse[0])
            self.lines[head : head + 2] = [f"{self.lines[head]} else {self.lines[head + 1].lstrip()}"]
        elif node.orelse:
            self.lines.pop()
            self.loop("} else {", node.orelse)

    def give_back(self, node: ast.Return) -> None:
        made = node.value
        assert made is not None
        if isinstance(made, ast.Call) and isinstance(made.func, ast.Name) and made.func.id in FIELDS:
            self.results = (made.func.id,)
            self.construct("made", made)
            self.emit("return made;")
            return
        if isinstance(made, ast.Tuple):
            values = [self.value(each) for each in made.elts]
            self.results = self.results or tuple(value.kind for value in values)
            for k, value in enumerate(values):
                self.emit(f"*r{k} = {value.text};")
            self.emit("return;")
            return
        value = self.value(made)
        self.results = self.results or (value.kind,)
        self.emit(f"return {bare(value.text)};")

    def assign(self, node: ast.Assign) -> None:
        value, targets = node.value, node.targets
        if len(targets) == 1 and isinstance(targets[0], ast.Tuple):
            self.assign_several(targets[0].elts, value)
            return
        last = targets[-1]
        if isinstance(value, ast.Call) and ast.unparse(value.func) in JOBS and isinstance(last, ast.Name):
            self.row_of_fields(last.id, value)
            return
        if is_constructor(value) and isinstance(last, ast.Name):
            assert isinstance(value, ast.Call)
            self.construct(last.id, value)
            return
        self.store(last, self.value(value))
        for target in targets[:-1]:
            self.store(target, self.value(last))

    def assign_several(self, targets: list[ast.expr], value: ast.expr) -> None:
        if isinstance(value, ast.Call) and self.name_of(value) in self.source.functions:
            name = self.name_of(value)
            kinds = self.source.results_of(name)
            if len(kinds) > 1:
                places = []
                for target, kind in zip(targets, kinds, strict=True):
                    if isinstance(target, ast.Name):
                        self.declare(target.id, kind)
                    places.append(f"&{self.value(target).text}")
                self.emit(f"{c_name(name)}({', '.join([*self.actual(value), *places])});")
                return
        assert isinstance(value, ast.Tuple)
        values = [self.value(each) for each in value.elts]
        for k, (target, each) in enumerate(zip(targets, values, strict=True)):
            later = " ".join(other.text for other in values[k + 1 :])
            if isinstance(target, ast.Name) and target.id in self.known and has_word(later, target.id):
                raise NotImplementedError(f"{self.node.name}:{value.lineno}: {target.id} is needed after it is set")
            self.store(target, each)

    def store(self, target: ast.expr, value: Value) -> None:
        if isinstance(target, ast.Name):
            self.declare(target.id, value.kind)
            if self.is_shared(value.kind) and not value.text.endswith(")"):
                self.addresses.add(target.id)
                value = value if value.is_address else Value(f"&{value.text}", value.kind, True)
        self.emit(f"{self.value(target).text} = {bare(value.text)};")

    def row_of_fields(self, name: str, call: ast.Call) -> None:
        """The row of fields at an address is the struct of that name."""
        kind, pointer = ast.unparse(call.func), next(n for n in ast.walk(call) if ast.unparse(n).startswith("carray"))
        assert isinstance(pointer, ast.Call)
        memory = pointer.args[0]
        self.declare(name, kind)
        self.addresses.add(name)
        if isinstance(memory, ast.Call):
            self.emit(f"{name} = (const {kind} *)(intptr_t){self.value(memory.args[0]).text};")
        else:
            self.emit(f"{name} = (const {kind} *)(const void *){ast.unparse(memory)};")

    @property
    def known(self) -> dict[str, str]:
        return {**self.kinds, **self.locals}

    def declare(self, name: str, kind: str) -> None:
        if name not in self.known:
            self.locals[name] = kind
        elif self.known[name] != kind and {self.known[name], kind} - {"double", "int"}:
            raise NotImplementedError(f"{self.node.name}: {name} is {self.known[name]} and {kind}")

    def construct(self, name: str, call: ast.Call) -> None:
        """Fill the fields of a tuple."""
        kind = self.name_of(call)
        if "." not in name:
            self.declare(name, kind)
        for field_name, argument in zip(FIELDS[kind], call.args, strict=True):
            key = in_cpp(field_name)
            if is_constructor(argument):
                assert isinstance(argument, ast.Call)
                self.construct(f"{name}.{key}", argument)
            else:
                self.emit(f"{name}.{key} = {bare(self.value(argument).text)};")

    # Expressions

    def condition(self, node: ast.expr) -> str:
        value = self.value(node)
        return "1" if value.text == "1" else value.text

    def value(self, node: ast.expr) -> Value:
        match node:
            case ast.Constant(value=bool() as flag):
                return Value("1" if flag else "0", "bool")
            case ast.Constant(value=int() | float() as number):
                return Value(repr(number), "int" if isinstance(number, int) else "double")
            case ast.Name(id=name):
                return self.name(name)
            case ast.Attribute():
                return self.attribute(node)
            case ast.Subscript():
                return self.subscript(node)
            case ast.Call():
                return self.call(node)
            case ast.UnaryOp():
                return self.unary(node)
            case ast.IfExp(test=test, body=body, orelse=other):
                a, b = self.value(body), self.value(other)
                kind = a.kind if a.kind == b.kind else "double"
                return Value(f"({self.condition(test)} ? {a.text} : {b.text})", kind)
            case ast.BinOp() | ast.Compare() | ast.BoolOp():
                return self.operation(node)
        raise NotImplementedError(f"{self.node.name}:{node.lineno}: {ast.unparse(node)}")

    def name(self, name: str) -> Value:
        if name in self.known:
            return Value(in_cpp(name), self.known[name], name in self.addresses)
        constant = self.source.constants[name]
        self.source.used[name] = constant
        kind = "tuple" if isinstance(constant, tuple) else "int" if isinstance(constant, int) else "double"
        return Value(name, kind)

    def attribute(self, node: ast.Attribute) -> Value:
        whole = ast.unparse(node)
        if whole in ("np.inf", "np.pi"):
            return Value({"np.inf": "HUGE_VAL", "np.pi": "3.141592653589793"}[whole], "double")
        if isinstance(node.value, ast.Name) and node.value.id == "stepping":
            return self.name(node.attr)
        owner = self.value(node.value)
        if node.attr == "size":
            return Value(f"{owner.text}.size", "int")
        kind = "int" if owner.kind in JOBS else FIELDS[owner.kind][node.attr]
        return Value(f"{owner.text}{'->' if owner.is_address else '.'}{in_cpp(node.attr)}", kind)

    def subscript(self, node: ast.Subscript) -> Value:
        index = node.slice
        if isinstance(node.value, ast.Attribute) and node.value.attr == "shape":
            owner = self.value(node.value.value)
            return Value(f"{owner.text}.{'rows' if ast.unparse(index) == '0' else 'columns'}", "int")
        owner = self.value(node.value)
        if isinstance(index, ast.Slice):
            first = self.value(index.lower).text if index.lower else "0"
            behind = self.value(index.upper).text if index.upper else f"{owner.text}.size"
            return Value(f"part_of({owner.text}, {bare(first)}, {bare(behind)})", "vector")
        if isinstance(index, ast.Tuple):
            row, column = (self.value(each).text for each in index.elts)
            return Value(f"{owner.text}.at[{row} * {owner.text}.columns + {column}]", ELEMENTS[owner.kind])
        place = bare(self.value(index).text)
        if place == "-1":
            place = f"{owner.text}.size - 1"
        if owner.kind == "matrix":
            return Value(f"row_of({owner.text}, {place})", "vector")
        if owner.kind == "cube":
            return Value(f"set_of({owner.text}, {place})", "matrix")
        if owner.kind == "tuple":
            return Value(f"{owner.text}[{place}]", "double")
        return Value(f"{owner.text}.at[{place}]", ELEMENTS[owner.kind])

    def unary(self, node: ast.UnaryOp) -> Value:
        inner = self.value(node.operand)
        if isinstance(node.op, ast.Not):
            return Value(f"!{inner.text}", "bool")
        return Value(f"-{inner.text}", inner.kind)

    def operation(self, node: ast.BinOp | ast.Compare | ast.BoolOp) -> Value:
        if isinstance(node, ast.BoolOp):
            joined = f" {OPERATORS[type(node.op)]} ".join(self.value(each).text for each in node.values)
            return Value(f"({joined})", "bool")
        if isinstance(node, ast.Compare):
            assert len(node.ops) == 1, ast.unparse(node)
            a, b, sign = self.value(node.left), self.value(node.comparators[0]), OPERATORS[type(node.ops[0])]
            return Value(f"({a.text} {sign} {b.text})", "bool")
        a, b = self.value(node.left), self.value(node.right)
        kind = "int" if a.kind == b.kind == "int" else "double"
        # Brackets only where they say something: not around products in sums, nor around what stands first.
        is_sum, of_left = isinstance(node.op, ast.Add | ast.Sub), isinstance(node.left, ast.BinOp)
        if of_left and (is_sum or isinstance(node.left.op, ast.Mult | ast.Div)):  # type: ignore[attr-defined]
            a = Value(bare(a.text), a.kind)
        if is_sum and isinstance(node.right, ast.BinOp) and isinstance(node.right.op, ast.Mult | ast.Div):
            b = Value(bare(b.text), b.kind)
        if isinstance(node.op, ast.Pow):
            return Value(f"pow({bare(a.text)}, {bare(b.text)})", "double")
        if isinstance(node.op, ast.FloorDiv):  # of what is not negative
            return Value(f"({a.text} / {b.text})", "int")
        return Value(f"({a.text} {OPERATORS[type(node.op)]} {b.text})", kind)

    def name_of(self, call: ast.Call) -> str:
        return ast.unparse(call.func).removeprefix("stepping.")

    def actual(self, call: ast.Call) -> list[str]:
        """Arguments of a call of a function of the house."""
        texts = []
        for k, argument in enumerate(call.args):
            if is_constructor(argument):
                assert isinstance(argument, ast.Call)
                name = f"made{sum(each.startswith('made') for each in self.locals) + 1}"
                self.construct(name, argument)
                texts.append(name)
                continue
            value = self.value(argument)
            wanted = self.source.functions[self.name_of(call)].args.args[k].arg
            texts.append(f"&{value.text}" if self.is_shared(value.kind) and not value.is_address else bare(value.text))
            assert wanted
        return texts

    def call(self, node: ast.Call) -> Value:
        name = self.name_of(node)
        if name in self.source.functions and name != "caller":
            kinds = self.source.results_of(name)
            actual = ", ".join(self.actual(node))
            return Value(f"{c_name(name)}({actual})", kinds[0] if kinds else "void")
        if name == "carray":
            return self.view(node)
        if name.startswith("call"):  # the first argument is the address of a function of the model
            address, *arrays = (self.value(each) for each in node.args)
            function = ast.unparse(node.args[0]).rpartition(".")[2]
            self.source.called.add(function)
            given = ", ".join(f"{array.text}.at" for array in arrays)
            return Value(f"((of_{function} *)(intptr_t){address.text})({given})", "void")
        values = [self.value(each) for each in node.args]
        if name in ("min", "max"):
            is_whole = all(value.kind == "int" for value in values)
            assert len(values) == 2, "of two"
            known = {"min": "least_integer" if is_whole else "least", "max": "most"}[name]
            given = ", ".join(bare(value.text) for value in values)
            return Value(f"{known}({given})", "int" if is_whole else "double")
        plain = {
            "abs": "fabs",
            "np.isfinite": "is_finite",
            "np.sin": "sin",
            "np.cos": "cos",
            "np.sqrt": "sqrt",
            "np.floor": "floor",
        }
        return Value(f"{plain[name]}({bare(values[0].text)})", "bool" if name == "np.isfinite" else "double")

    def view(self, node: ast.Call) -> Value:
        """Memory at an address, of some shape."""
        pointer, shape = node.args
        assert isinstance(pointer, ast.Call)
        assert isinstance(shape, ast.Tuple)
        element = self.name_of(pointer).removesuffix("_at")
        sizes = [bare(self.value(each).text) for each in shape.elts]
        kinds = {
            "doubles": ("vector", "matrix", "cube"),
            "integers": ("integers", "integer_matrix"),
            "flags": ("flags",),
        }[element]
        kind = kinds[len(sizes) - 1]
        address = bare(self.value(pointer.args[0]).text)
        return Value(f"{kind}_at({', '.join([address, *sizes])})", kind)


def is_constructor(node: ast.expr) -> bool:
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in FIELDS


def in_cpp(name: str) -> str:
    """A name that is no word of C++."""
    return "new_x" if name == "new" else name


def c_name(name: str) -> str:
    return name if name in (INTEGRATOR.entry, ESTIMATOR.entry) else f"do_{name.lstrip('_')}"


def declaration(kind: str, name: str, is_address: bool, *, is_argument: bool = False) -> str:
    if is_address:
        return f"const {kind} *{name}"
    # What a branch decides begins with nothing, so that a compiler sees that it is set.
    begin = {"double": " = 0.0", "int": " = 0", "bool": " = 0"}.get(kind, "")
    return f"{C_TYPES.get(kind, kind)} {in_cpp(name)}{'' if is_argument else begin}"


def bare(text: str) -> str:
    """Without the brackets around all of it."""
    if not (text.startswith("(") and text.endswith(")")):
        return text
    depth = 0
    for k, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        if depth == 0 and k < len(text) - 1:
            return text
    return text[1:-1]


def has_word(text: str, word: str) -> bool:
    return any(part == word for part in text.replace(".", " ").replace("-", " ").translate(_APART).split())


_APART = str.maketrans(dict.fromkeys("()[],*+/<>=&?:!;", " "))


def job_fields(name: str) -> list[str]:
    """Fields of a job, in order."""
    tree = ast.parse((ENGINE / f"{JOBS[name]}.py").read_text(encoding="utf-8"))
    (job,) = (node for node in tree.body if isinstance(node, ast.ClassDef) and node.name == name)
    return [n.target.id for n in job.body if isinstance(n, ast.AnnAssign) and isinstance(n.target, ast.Name)]


def kernel_types(called: set[str]) -> list[str]:
    """Types of the functions of a model that the program calls."""
    found = []
    for name, signature in KERNEL.items():
        if name not in called:
            continue
        given, _, made = signature.partition("->")
        formal = [f"double *{a}" if a == "w" else f"const double *{a}" for a in given.split()]
        found.append(f"typedef void of_{name}({', '.join([*formal, *(f'double *{a}' for a in made.split())])});")
    return found


def structs(program: Program, texts: Sequence[str]) -> list[str]:
    found: list[str] = []
    for name in program.jobs:
        found += ["", "typedef struct {", *(f"  int64_t {field};" for field in job_fields(name)), f"}} {name};"]
    used = {kind for kind in FIELDS if any(has_word(text, kind) for text in texts)}
    for name, fields in FIELDS.items():
        if name not in used | {kind for owner in used for kind in FIELDS[owner].values()}:
            continue
        found += [
            "",
            "typedef struct {",
            *(f"  {C_TYPES.get(k, k)} {in_cpp(n)};" for n, k in fields.items()),
            f"}} {name};",
        ]
    return found[1:]


def views(texts: Sequence[str]) -> str:
    """The views of memory and the mathematics that the program needs."""
    blocks = VIEWS.strip().split("\n\n")
    names = [block.partition("(")[0].split()[-1] for block in blocks]
    needed = [k == 0 or any(has_word(text, name) for text in texts) for k, name in enumerate(names)]
    return "\n\n".join(block for block, is_needed in zip(blocks, needed, strict=True) if is_needed)


def constants(used: dict[str, object]) -> list[str]:
    lines = []
    for name, value in sorted(used.items()):
        if isinstance(value, tuple):
            lines.append(f"static const double {name}[{len(value)}] = {{{', '.join(map(repr, value))}}};")
        else:
            lines.append(f"#define {name} {value!r}")
    return lines


def integrator_c(program: Program = INTEGRATOR) -> str:
    """The integrator, or another program, as C."""
    source = Source()
    for name in program.files:
        source.read(ENGINE / f"{name}.py")
    source.results_of(program.entry)
    texts = source.texts
    parts = [
        program.about, "#include <math.h>\n#include <stdint.h>", "\n".join(kernel_types(source.called)), views(texts),
        "\n".join(structs(program, texts)), "\n".join(constants(source.used)), *texts,
    ]  # fmt: skip
    return "\n\n".join(parts)


if __name__ == "__main__":
    print(integrator_c())
