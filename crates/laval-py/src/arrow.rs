//! Tables over the Arrow C interfaces: numbers where they lie, texts and flags in the layout of Arrow.
//!
//! Every exported array holds the table it is a view of. Structures are those of the specification, <https://arrow.apache.org/docs/format/CDataInterface.html>;
//! a consumer calls `release` of each once, or moves a child out and releases it later.

use crate::table::Held;
use laval::outcome::{Column, Data, Table};
use pyo3::ffi;
use pyo3::prelude::*;
use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr::{null, null_mut};
use std::sync::Arc;

type Release<T> = Option<unsafe extern "C" fn(*mut T)>;

/// `struct ArrowSchema`.
#[repr(C)]
pub struct Schema {
    format: *const c_char,
    name: *const c_char,
    metadata: *const c_char,
    flags: i64,
    n_children: i64,
    children: *mut *mut Schema,
    dictionary: *mut Schema,
    release: Release<Schema>,
    private_data: *mut c_void,
}

/// `struct ArrowArray`.
#[repr(C)]
pub struct Array {
    length: i64,
    null_count: i64,
    offset: i64,
    n_buffers: i64,
    n_children: i64,
    buffers: *mut *const c_void,
    children: *mut *mut Array,
    dictionary: *mut Array,
    release: Release<Array>,
    private_data: *mut c_void,
}

/// `struct ArrowArrayStream`.
#[repr(C)]
pub struct Stream {
    get_schema: Option<unsafe extern "C" fn(*mut Stream, *mut Schema) -> c_int>,
    get_next: Option<unsafe extern "C" fn(*mut Stream, *mut Array) -> c_int>,
    get_last_error: Option<unsafe extern "C" fn(*mut Stream) -> *const c_char>,
    release: Release<Stream>,
    private_data: *mut c_void,
}

/// What a schema owns.
struct Named {
    name: CString,
    metadata: Vec<u8>,
    children: Vec<*mut Schema>,
}

/// What an array owns: the table whose memory it shows, and what had to be laid out anew.
struct Shown {
    _held: Arc<Held>,
    _laid_out: Vec<Vec<u8>>,
    buffers: Vec<*const c_void>,
    children: Vec<*mut Array>,
}

/// The next table of a stream; `None` behind the last one.
pub type Next = Box<dyn FnMut() -> Result<Option<Arc<Held>>, String> + Send>;

/// What a stream owns.
struct Source {
    /// A table with its columns.
    like: Arc<Held>,
    next: Next,
    error: Option<CString>,
}

/// An input or output error of the system, as `errno` has it.
const EIO: c_int = 5;

fn finished_schema(format: &'static CStr, name: &str, metadata: Vec<u8>, children: Vec<Schema>) -> Schema {
    let children = children.into_iter().map(|c| Box::into_raw(Box::new(c))).collect();
    // a name that holds a NUL ends there
    let name = CString::new(name.split('\0').next().unwrap_or_default()).unwrap_or_default();
    let mut own = Box::new(Named { name, metadata, children });
    Schema {
        format: format.as_ptr(),
        name: own.name.as_ptr(),
        metadata: if own.metadata.is_empty() { null() } else { own.metadata.as_ptr().cast() },
        flags: 0,
        n_children: own.children.len() as i64,
        children: own.children.as_mut_ptr(),
        dictionary: null_mut(),
        release: Some(release_schema),
        private_data: Box::into_raw(own).cast(),
    }
}

/// Keys and values in the layout of the specification: counts and lengths as 32-bit integers.
fn metadata(entries: &[(&str, &str)]) -> Vec<u8> {
    let entries: Vec<_> = entries.iter().filter(|e| !e.1.is_empty()).collect();
    let mut out = Vec::new();
    if entries.is_empty() {
        return out;
    }
    let number = |out: &mut Vec<u8>, n: usize| out.extend((n as i32).to_ne_bytes());
    number(&mut out, entries.len());
    for (key, value) in entries {
        for text in [key, value] {
            number(&mut out, text.len());
            out.extend(text.as_bytes());
        }
    }
    out
}

/// The schema of a column: its unit and explanation are metadata.
pub fn schema_of(column: &Column) -> Schema {
    let format = match column.data {
        Data::Float(_) => c"g",
        Data::Int(_) => c"l",
        Data::Flag(_) => c"b",
        Data::Text(_) => c"U",
    };
    finished_schema(format, &column.name, metadata(&[("unit", &column.unit), ("doc", &column.doc.to_string())]), Vec::new())
}

/// The schema of a table: a structure of its columns.
pub fn schema(table: &Table) -> Schema {
    let columns = table.columns().iter().map(schema_of).collect();
    finished_schema(c"+s", table.name(), metadata(&[("name", table.name()), ("doc", &table.doc().to_string())]), columns)
}

fn finished_array(held: &Arc<Held>, length: usize, buffers: Vec<*const c_void>, laid_out: Vec<Vec<u8>>, children: Vec<Array>) -> Array {
    let children = children.into_iter().map(|c| Box::into_raw(Box::new(c))).collect();
    let mut own = Box::new(Shown { _held: held.clone(), _laid_out: laid_out, buffers, children });
    Array {
        length: length as i64,
        null_count: 0,
        offset: 0,
        n_buffers: own.buffers.len() as i64,
        n_children: own.children.len() as i64,
        buffers: own.buffers.as_mut_ptr(),
        children: own.children.as_mut_ptr(),
        dictionary: null_mut(),
        release: Some(release_array),
        private_data: Box::into_raw(own).cast(),
    }
}

/// The values of a column.
pub fn array_of(held: &Arc<Held>, column: usize) -> Array {
    let data = &held.get().columns()[column].data;
    // no value is missing: of numbers, NaN stands for "no value"
    let valid: *const c_void = null();
    let (buffers, laid_out) = match data {
        Data::Float(v) => (vec![valid, v.as_ptr().cast()], Vec::new()),
        Data::Int(v) => (vec![valid, v.as_ptr().cast()], Vec::new()),
        Data::Flag(v) => {
            let bits: Vec<u8> = v.chunks(8).map(|c| c.iter().enumerate().fold(0, |b, (k, &x)| b | u8::from(x) << k)).collect();
            (vec![valid, bits.as_ptr().cast()], vec![bits])
        }
        Data::Text(v) => {
            let mut offsets: Vec<u8> = Vec::with_capacity(8 * (v.len() + 1));
            let mut text: Vec<u8> = Vec::new();
            offsets.extend(0i64.to_ne_bytes());
            for s in v {
                text.extend(s.as_bytes());
                offsets.extend((text.len() as i64).to_ne_bytes());
            }
            (vec![valid, offsets.as_ptr().cast(), text.as_ptr().cast()], vec![offsets, text])
        }
    };
    finished_array(held, data.len(), buffers, laid_out, Vec::new())
}

fn array(held: &Arc<Held>) -> Array {
    let table = held.get();
    let columns = (0..table.columns().len()).map(|k| array_of(held, k)).collect();
    finished_array(held, table.rows(), vec![null()], Vec::new(), columns)
}

/// A stream of one record batch.
pub fn stream(held: Arc<Held>) -> Stream {
    let mut left = Some(held.clone());
    stream_of(held, Box::new(move || Ok(left.take())))
}

/// A stream of tables that have the columns of `like`, one at a time.
pub fn stream_of(like: Arc<Held>, next: Next) -> Stream {
    Stream {
        get_schema: Some(stream_schema),
        get_next: Some(stream_next),
        get_last_error: Some(stream_error),
        release: Some(release_stream),
        private_data: Box::into_raw(Box::new(Source { like, next, error: None })).cast(),
    }
}

// SAFETY of all below: consumers call these with the structures made above, as the specification says, and not after their release.

unsafe extern "C" fn release_schema(s: *mut Schema) {
    let own = unsafe { Box::from_raw((*s).private_data.cast::<Named>()) };
    for &child in &own.children {
        let mut child = unsafe { Box::from_raw(child) };
        if let Some(release) = child.release {
            unsafe { release(&mut *child) };
        }
    }
    unsafe { (*s).release = None };
}

unsafe extern "C" fn release_array(a: *mut Array) {
    let own = unsafe { Box::from_raw((*a).private_data.cast::<Shown>()) };
    for &child in &own.children {
        let mut child = unsafe { Box::from_raw(child) };
        if let Some(release) = child.release {
            unsafe { release(&mut *child) };
        }
    }
    unsafe { (*a).release = None };
}

unsafe extern "C" fn stream_schema(s: *mut Stream, out: *mut Schema) -> c_int {
    let source = unsafe { &*(*s).private_data.cast::<Source>() };
    unsafe { out.write(schema(source.like.get())) };
    0
}

unsafe extern "C" fn stream_next(s: *mut Stream, out: *mut Array) -> c_int {
    let source = unsafe { &mut *(*s).private_data.cast::<Source>() };
    let next =
        catch_unwind(AssertUnwindSafe(|| (source.next)())).unwrap_or_else(|_| Err("the next table failed: a defect of laval".into()));
    let next = match next {
        Ok(Some(held)) => array(&held),
        // the end: an array that is released already
        Ok(None) => Array { release: None, ..unsafe { std::mem::zeroed() } },
        Err(why) => {
            source.error = CString::new(why.replace('\0', " ")).ok();
            return EIO;
        }
    };
    unsafe { out.write(next) };
    0
}

unsafe extern "C" fn stream_error(s: *mut Stream) -> *const c_char {
    let source = unsafe { &*(*s).private_data.cast::<Source>() };
    source.error.as_ref().map_or(null(), |e| e.as_ptr())
}

unsafe extern "C" fn release_stream(s: *mut Stream) {
    drop(unsafe { Box::from_raw((*s).private_data.cast::<Source>()) });
    unsafe { (*s).release = None };
}

/// A structure that travels in a capsule.
pub trait Travels: Sized {
    /// The name that the specification gives its capsule.
    const NAME: &'static CStr;
    /// Releases it unless a consumer has.
    fn release(&mut self);
}

macro_rules! travels {
    ($($kind:ident $name:literal),*) => { $(
        impl Travels for $kind {
            const NAME: &'static CStr = $name;
            fn release(&mut self) {
                if let Some(release) = self.release {
                    // SAFETY: it was not released before
                    unsafe { release(self) };
                }
            }
        }
    )* };
}
travels!(Schema c"arrow_schema", Array c"arrow_array", Stream c"arrow_array_stream");

unsafe extern "C" fn forget<T: Travels>(capsule: *mut ffi::PyObject) {
    // SAFETY: only `capsule` below makes capsules with this destructor
    let inside = unsafe { ffi::PyCapsule_GetPointer(capsule, T::NAME.as_ptr()) }.cast::<T>();
    if !inside.is_null() {
        unsafe { Box::from_raw(inside) }.release();
    }
}

/// The capsule of a structure, which owns it until a consumer moves it out.
pub fn capsule<T: Travels>(py: Python<'_>, inside: T) -> PyResult<Bound<'_, PyAny>> {
    let raw = Box::into_raw(Box::new(inside));
    // SAFETY: the pointer is not null, the name is static, the destructor takes the box back
    unsafe {
        let capsule = ffi::PyCapsule_New(raw.cast(), T::NAME.as_ptr(), Some(forget::<T>));
        if capsule.is_null() {
            Box::from_raw(raw).release();
        }
        Bound::from_owned_ptr_or_err(py, capsule)
    }
}
