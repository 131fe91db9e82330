//! What numerics say in diagnostics.

use crate::text;
use crate::text::{Arg, Argument};
use laval_num::continuation::{Failure as Undefined, Invalid};
use laval_num::dense::Singular;
use laval_num::eig::EigError;
use laval_num::interpolate::TableError;
use laval_num::ode::Failure;
use std::borrow::Cow;

impl Argument for TableError {
    fn argument(&self) -> Arg {
        let said = match self {
            TableError::Empty => text!("the table has no rows"),
            TableError::Lengths(x, y) => text!("the columns have {x} and {y} rows", x, y),
            TableError::NotFinite(row) => text!("row {row} holds a number that is not finite", row = row + 1),
            TableError::NotIncreasing(row) => text!("the argument in row {row} is not above the one before", row = row + 1),
        };
        said.argument()
    }
}

impl Argument for Singular {
    fn argument(&self) -> Arg {
        text!("singular matrix (no pivot in column {column})", column = self.column).argument()
    }
}

impl Argument for EigError {
    fn argument(&self) -> Arg {
        let said = match self {
            EigError::NotFinite => text!("a matrix of the eigenvalue problem has an entry that is not finite"),
            EigError::NoConvergence => text!("the eigenvalue iteration did not converge"),
            EigError::SingularPencil => text!("every number is an eigenvalue: the determinant vanishes identically"),
        };
        said.argument()
    }
}

impl Argument for Invalid {
    fn argument(&self) -> Arg {
        Arg::Term(self.0)
    }
}

impl Argument for Undefined {
    fn argument(&self) -> Arg {
        match self {
            Undefined::Undefined(why) => text!("the equations are not defined here: {why}", why = text::term(why)).argument(),
            Undefined::Cancelled => text!("cancelled").argument(),
        }
    }
}

impl Argument for Failure {
    fn argument(&self) -> Arg {
        match &self.0 {
            Cow::Borrowed(what) => Arg::Term(what),
            Cow::Owned(what) => Arg::Plain(what.clone()),
        }
    }
}
