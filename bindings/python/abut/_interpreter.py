"""Refuses sub-interpreters, before anything is loaded that is there once for the whole process."""


def is_main_interpreter() -> bool:
    """Tells whether this is the interpreter that the process began with."""
    try:
        import ctypes
    except ImportError as error:
        # Sub-interpreters of 3.12 do not load it, if they have a lock of their own.
        return "subinterpreters" not in str(error)
    current = ctypes.pythonapi.PyInterpreterState_Get
    current.restype = ctypes.c_void_p
    number = ctypes.pythonapi.PyInterpreterState_GetID
    number.argtypes, number.restype = [ctypes.c_void_p], ctypes.c_int64
    return bool(number(current()) == 0)


def require_main_interpreter() -> None:
    """Raises ImportError in a sub-interpreter. A module that is loaded there would take the types
    of the compiled part away from the main interpreter."""
    if not is_main_interpreter():
        raise ImportError(
            "abut does not support sub-interpreters: import it in the main interpreter, or in a "
            "process of its own"
        )


require_main_interpreter()
