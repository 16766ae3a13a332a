"""What tables are in machine code: pointers and nothing else. Imported only where numba compiles.

Kernels say `t.bodies.x[row]`. Interpreted, these are named tuples of memoryviews. Compiled, every
table is the same pointer to one array of addresses, its *directory*; `.x` loads the address that
stands at the place of that column, and `[row]` loads eight bytes from there. Columns whose rows lie
side by side share the address of the first one. Nothing is counted, checked or wrapped around, and
a call from Python hands over a single number.
"""

import operator
from collections.abc import Callable
from ctypes import addressof, c_char
from functools import cache, partial
from typing import Any, get_type_hints

import numpy as np
from llvmlite import ir
from numba import njit, types
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompilerBase, PassManager
from numba.core.typed_passes import (
    IRLegalization,
    NativeLowering,
    NoPythonBackend,
    NopythonTypeInference,
    PreLowerStripPhis,
)
from numba.core.typing.templates import (
    AbstractTemplate,
    AttributeTemplate,
    infer_global,
    signature,
)
from numba.core.untyped_passes import FixupArgs, IRProcessing, ReconstructSSA, TranslateByteCode
from numba.extending import (
    infer_getattr,
    intrinsic,
    lower_builtin,
    lower_getattr_generic,
    models,
    register_jitable,
    register_model,
)

from engine.kernels import tick
from engine.settings import Laws
from engine.tables import Floats, Ints, Tables, clear_row, copy_row, side_by_side

WORD = ir.IntType(64)
SCALARS = {float: types.float64, int: types.int64}
COLUMNS = {Floats: types.float64, Ints: types.int64}
MACHINE = {types.float64: ir.DoubleType(), types.int64: WORD}


class Column(types.Type):
    """A pointer to the first of evenly spaced float64 or int64."""

    def __init__(self, name: str, kind: Any, shift: int, stride: int) -> None:
        super().__init__(f"Column({name})")
        self.column = name
        self.kind = kind
        self.shift = shift
        """Where it begins, from the address in the directory (words)."""
        self.stride = stride
        """From one row to the next (words)."""


class Handle(types.Type):
    """A pointer to the directory, and which part of it is meant."""

    def __init__(self, part: Any, first: int) -> None:
        super().__init__(f"Handle({part.__name__}, {first})")
        self.part = part
        self.first = first


@cache
def members(part: Any, first: int) -> dict[str, tuple[Any, int]]:
    """For each member of a table or tuple of tables: what it is, and its word in the directory."""
    found: dict[str, tuple[Any, int]] = {}
    at = first
    together = side_by_side(part)
    start = first + part._fields.index(together[0]) if together else first
    for name, kind in get_type_hints(part).items():
        if kind in COLUMNS:
            shared = name in together
            shift, stride = (together.index(name), len(together)) if shared else (0, 1)
            column = Column(f"{part.__name__}.{name}", COLUMNS[kind], shift, stride)
            found[name] = (column, start if shared else at)
        elif kind in SCALARS:
            found[name] = (SCALARS[kind], at)
        else:
            found[name] = (Handle(kind, at), at)
        at += words(kind)
    return found


def words(kind: Any) -> int:
    """Number of words of the directory that something takes."""
    if hasattr(kind, "_fields"):
        return sum(words(inner) for inner in get_type_hints(kind).values())
    return 1


@register_model(Column)
class ColumnModel(models.PrimitiveModel):
    """One machine word."""

    def __init__(self, dmm: Any, fe_type: Column) -> None:
        super().__init__(dmm, fe_type, MACHINE[fe_type.kind].as_pointer())


@register_model(Handle)
class HandleModel(models.PrimitiveModel):
    """One machine word."""

    def __init__(self, dmm: Any, fe_type: Handle) -> None:
        super().__init__(dmm, fe_type, WORD.as_pointer())


@infer_getattr
class Members(AttributeTemplate):
    """The type of `table.column`."""

    key = Handle

    def generic_resolve(self, handle: Handle, name: str) -> Any:
        return members(handle.part, handle.first).get(name, (None, 0))[0]


@lower_getattr_generic(Handle)
def load_member(context: Any, builder: Any, handle: Handle, value: Any, name: str) -> Any:
    """The address of a column, or the value of a scalar."""
    kind, at = members(handle.part, handle.first)[name]
    if isinstance(kind, Handle):
        return value
    place = builder.gep(value, [WORD(at)], inbounds=True)
    machine = MACHINE[kind.kind].as_pointer() if isinstance(kind, Column) else MACHINE[kind]
    loaded = builder.load(builder.bitcast(place, machine.as_pointer()))
    loaded.set_metadata("invariant.load", builder.module.add_metadata([]))
    if isinstance(kind, Column) and kind.shift > 0:
        return builder.gep(loaded, [WORD(kind.shift)], inbounds=True)
    return loaded


def place_of(builder: Any, column: Column, start: Any, row: Any) -> Any:
    """The address of a row of a column."""
    if column.stride > 1:
        row = builder.mul(row, WORD(column.stride), flags=("nsw",))
    return builder.gep(start, [row], inbounds=True)


@infer_global(operator.getitem)
class Reads(AbstractTemplate):
    """The type of `column[row]`."""

    def generic(self, args: Any, kws: Any) -> Any:
        if isinstance(args[0], Column) and isinstance(args[1], types.Integer):
            return signature(args[0].kind, args[0], types.intp)
        return None


@infer_global(operator.setitem)
class Writes(AbstractTemplate):
    """The type of `column[row] = value`."""

    def generic(self, args: Any, kws: Any) -> Any:
        if isinstance(args[0], Column) and isinstance(args[1], types.Integer):
            whole = isinstance(args[2], types.Integer | types.Boolean)
            if whole or (args[0].kind is types.float64 and args[2] is types.float64):
                return signature(types.none, args[0], types.intp, args[0].kind)
        return None


def own_memory(builder: Any, access: Any, column: Column) -> Any:
    """Tell LLVM that columns do not overlap, so that it keeps what it read from the others."""
    module = builder.module
    root = module.add_metadata(["tables"])
    kind = module.add_metadata([column.column, root, WORD(0)])
    access.set_metadata("tbaa", module.add_metadata([kind, kind, WORD(0)]))
    return access


@lower_builtin(operator.getitem, Column, types.intp)
def read(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    """Load eight bytes."""
    place = place_of(builder, sig.args[0], args[0], args[1])
    return own_memory(builder, builder.load(place), sig.args[0])


@lower_builtin(operator.setitem, Column, types.intp, types.Any)
def write(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    """Store eight bytes."""
    place = place_of(builder, sig.args[0], args[0], args[1])
    own_memory(builder, builder.store(args[2], place), sig.args[0])
    return context.get_dummy_value()


def at_address(part: Any, first: int) -> Any:
    """Make the function that turns the address of a directory into a handle of a part of it."""

    @intrinsic
    def handle(typing: Any, address: Any) -> Any:
        def lower(context: Any, builder: Any, sig: Any, args: Any) -> Any:
            return builder.inttoptr(args[0], WORD.as_pointer())

        return Handle(part, first)(types.int64), lower

    return handle


tables_at = at_address(Tables, 0)
laws_at = at_address(Laws, words(Tables))


def directory(tables: Tables, laws: Laws) -> Any:
    """The array of addresses of all columns, then the laws, for `tables_at` and `laws_at`."""
    addresses = [address for table in tables for address in addresses_of(table)]
    scalars = np.zeros(len(laws), np.int64)
    for i, (value, kind) in enumerate(zip(laws, get_type_hints(Laws).values(), strict=True)):
        scalars.view(np.float64 if kind is float else np.int64)[i] = value
    return np.concatenate((np.array(addresses, np.int64), scalars))


def addresses_of(table: Any) -> list[int]:
    """Where the numbers of each column of a table begin.

    Asking numpy takes seven times as long, which was most of a new world's first tick.
    """
    if len(table[0]) == 0:
        return [0] * len(table)
    begin = c_char.from_buffer
    return [addressof(begin(column[:1])) for column in table]


@infer_global(copy_row)
class CopiesRow(AbstractTemplate):
    """The type of `copy_row(table, source, target)`."""

    def generic(self, args: Any, kws: Any) -> Any:
        return signature(types.none, args[0], types.intp, types.intp)


@lower_builtin(copy_row, Handle, types.intp, types.intp)
def copy(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    """Copy a row, column by column."""
    for name, (column, _) in members(sig.args[0].part, sig.args[0].first).items():
        start = load_member(context, builder, sig.args[0], args[0], name)
        source = place_of(builder, column, start, args[1])
        target = place_of(builder, column, start, args[2])
        value = own_memory(builder, builder.load(source), column)
        own_memory(builder, builder.store(value, target), column)
    return context.get_dummy_value()


@infer_global(clear_row)
class ClearsRow(AbstractTemplate):
    """The type of `clear_row(table, row)`."""

    def generic(self, args: Any, kws: Any) -> Any:
        return signature(types.none, args[0], types.intp)


@lower_builtin(clear_row, Handle, types.intp)
def clear(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    """Clear a row, column by column."""
    for name, (column, _) in members(sig.args[0].part, sig.args[0].first).items():
        start = load_member(context, builder, sig.args[0], args[0], name)
        place = place_of(builder, column, start, args[1])
        zero = ir.Constant(MACHINE[column.kind], 0)
        own_memory(builder, builder.store(zero, place), column)
    return context.get_dummy_value()


SIGNATURE = "int64(int64, float64, int64)"

PLAIN = {"error_model": "numpy", "_nrt": False}
"""Options of all compiled functions: nothing raises, nothing is counted."""


class Ingredient(JITCodeLibrary):
    """Code of one kernel, which becomes machine code only as part of the outermost function.

    Numba would link every kernel with all that it calls, optimise the whole and translate it, again
    and again on every level of calls, though nobody ever calls a kernel but another one.
    """

    def finalize(self) -> None:
        """Leave the code as it is."""
        self._finalized = True

    def _get_module_for_linking(self) -> Any:
        """The code of this kernel and of all that it calls, each once."""
        if self._shared_module is None:
            linked = {self}
            waiting = [self]
            while waiting:
                for library in waiting.pop()._linking_libraries:
                    if library not in linked:
                        linked.add(library)
                        if isinstance(library, Ingredient):
                            waiting.append(library)
                            library = library._final_module
                        else:
                            library = library._get_module_for_linking()
                        self._final_module.link_in(library, preserve=True)
            super()._get_module_for_linking()
        return self._shared_module

    def get_pointer_to_function(self, name: str) -> int:
        """None: nobody calls it by itself."""
        return 0

    @property
    def codegen(self) -> Any:
        """What would tell the code of its Python environment, which kernels have not."""
        return self

    def set_env(self, name: str, env: Any) -> None:
        """Do nothing."""


PASSES = (
    TranslateByteCode,
    FixupArgs,
    IRProcessing,
    ReconstructSSA,
    NopythonTypeInference,
    PreLowerStripPhis,
    IRLegalization,
    NativeLowering,
    NoPythonBackend,
)
"""What turns a kernel into code: numba's passes without those for what no kernel has."""


class Preparing(CompilerBase):
    """Compiles a kernel up to code that is to be linked."""

    def define_pipelines(self) -> Any:
        """Let it become an `Ingredient`."""
        codegen = self.state.targetctx.codegen()
        self.state.library = Ingredient(codegen, self.state.func_id.func_qualname)
        passes = PassManager("kernels")
        for each in PASSES:
            passes.add_pass(each, each._name)
        passes.finalize()
        return [passes]


def let_kernels_call(function: Any) -> None:
    """Let compiled functions call a kernel."""
    register_jitable(
        pipeline_class=Preparing, no_cpython_wrapper=True, no_cfunc_wrapper=True, **PLAIN
    )(function)


def entry(sources: str) -> Callable[[int, float, int], int]:
    """Make the outermost function, which finds the tables at an address."""
    version = sources

    def run(address: int, dt: float, ticks: int) -> int:
        _ = version
        return tick.run(tables_at(address), laws_at(address), dt, ticks)

    return run


def outermost(sources: str) -> tuple[Any, str | None]:
    """Make the function to compile, and say where its code is kept; None: nowhere.

    `sources` is part of the key under which it is kept.
    """
    try:
        kernel = njit(cache=True, nogil=True, **PLAIN)(entry(sources))
    except RuntimeError:  # numba found no folder that can be written
        return njit(nogil=True, **PLAIN)(entry(sources)), None
    return kernel, kernel.stats.cache_path


def compile_now(kernel: Any) -> Callable[[Tables, Laws], Callable[[float, int], int]]:
    """Compile the function or load its code; return what binds it to tables."""
    kernel.compile(SIGNATURE)
    # What numba calls once it has looked at the types of arguments, which takes longer than a tick.
    call = kernel.overloads[kernel.signatures[0]].entry_point

    def bind(tables: Tables, laws: Laws) -> Callable[[float, int], int]:
        held = directory(tables, laws)
        bound: Any = partial(call, int(held.ctypes.data))
        bound.keeps_alive = held, tables, kernel
        return bound  # type: ignore[no-any-return]

    return bind
