//! A capability that is implemented is declared: the method of [`Part`] that returns it is easily forgotten.

use crate::model::capability::{
    AddedInertia, BodyPart, Contacts, Extent, Filling, FrequencyDomain, MovableMasses, ReplacedInTime, Scope, SpinDrive, VaryingInertia,
};
use crate::model::part::Part;
use std::marker::PhantomData;

/// Which capabilities a part implements, as constants: those of the type where it does, those of [`Otherwise`] where not.
pub struct Implements<P>(PhantomData<P>);

macro_rules! capabilities {
    ($( $name:ident: $trait:ident, $method:ident; )*) => {
        /// Constants of a part that does not implement a capability.
        #[allow(missing_docs)]
        pub trait Otherwise {
            $( const $name: bool = false; )*
        }
        impl<P> Otherwise for Implements<P> {}
        $(
            impl<P: $trait> Implements<P> {
                /// Implemented.
                pub const $name: bool = true;
            }
        )*

        /// The capabilities that a part declares, in the order of [`implemented!`](crate::implemented).
        pub fn declared<P: Part>(part: &P) -> Vec<(&'static str, bool)> {
            vec![$( (stringify!($method), part.$method().is_some()) ),*]
        }
    };
}

capabilities! {
    BODY: BodyPart, body;
    EXTENT: Extent, extent;
    CONTACTS: Contacts, contacts;
    MOVABLE_MASSES: MovableMasses, movable_masses;
    VARYING_INERTIA: VaryingInertia, varying_inertia;
    ADDED_INERTIA: AddedInertia, added_inertia;
    FREQUENCY_DOMAIN: FrequencyDomain, frequency_domain;
    REPLACED_IN_TIME: ReplacedInTime, replaced_in_time;
    SPIN_DRIVE: SpinDrive, spin_drive;
    FILLING: Filling, filling;
    SCOPE: Scope, scope;
}

/// The capabilities that a part's type implements, in the order of [`declared`](crate::model::conformance::declared).
#[doc(hidden)]
#[macro_export]
macro_rules! implemented {
    ($part:ty) => {{
        #[allow(unused_imports)]
        use $crate::model::conformance::Otherwise as _;
        type Of = $crate::model::conformance::Implements<$part>;
        [
            Of::BODY,
            Of::EXTENT,
            Of::CONTACTS,
            Of::MOVABLE_MASSES,
            Of::VARYING_INERTIA,
            Of::ADDED_INERTIA,
            Of::FREQUENCY_DOMAIN,
            Of::REPLACED_IN_TIME,
            Of::SPIN_DRIVE,
            Of::FILLING,
            Of::SCOPE,
        ]
    }};
}

/// Capabilities that are implemented and that none of the variants of a part declares.
pub fn undeclared(implemented: [bool; 11], variants: &[Vec<(&'static str, bool)>]) -> Vec<&'static str> {
    let Some(names) = variants.first() else { return Vec::new() };
    let none = |k: usize| variants.iter().all(|v| !v[k].1);
    (0..implemented.len()).filter(|&k| implemented[k] && none(k)).map(|k| names[k].0).collect()
}
