//! The linear complementarity problem of a cluster: `λ ≥ 0`, `A λ + u ≥ 0`, `λ·(A λ + u) = 0`.
//!
//! A is symmetric and positive semidefinite. Where it is singular (a rack has more contacts than degrees of freedom) the
//! velocities are still unique, and λ is not; proximal steps from λ = 0 then give the λ without a part in A's null space,
//! the least-norm one wherever all its entries are positive. Each step is a strictly convex problem, solved by Murty's
//! principal pivoting, which ends.

use crate::scalar::Scalar;

/// Weight of the proximal term, relative to the largest diagonal entry.
const PROXIMAL_WEIGHT: f64 = 1e-4;
const MAX_PROXIMAL_STEPS: usize = 200;

/// The impulses λ for the matrix A and the gap rates u.
pub fn solve_complementarity<S: Scalar>(matrix: &[Vec<S>], rates: &[S]) -> Vec<S> {
    let size = rates.len();
    if size == 1 {
        return vec![if rates[0] < S::ZERO { -rates[0] / matrix[0][0] } else { S::ZERO }];
    }
    let weight = largest((0..size).map(|k| matrix[k][k])) * S::from_f64(PROXIMAL_WEIGHT);
    let mut damped = matrix.to_vec();
    for (k, row) in damped.iter_mut().enumerate() {
        row[k] += weight;
    }
    let mut solution = vec![S::ZERO; size];
    let mut active = vec![true; size];
    for _ in 0..MAX_PROXIMAL_STEPS {
        let shifted: Vec<S> = (0..size).map(|k| rates[k] - weight * solution[k]).collect();
        let next = pivot(&damped, &shifted, &mut active);
        let change = largest((0..size).map(|k| (next[k] - solution[k]).abs()));
        solution = next;
        if change <= largest(solution.iter().copied()) * S::from_f64(4.0 * S::EPSILON) {
            break;
        }
    }
    solution
}

/// Murty's principal pivoting on a positive definite matrix: exchange the first entry that is on the wrong side.
fn pivot<S: Scalar>(matrix: &[Vec<S>], rates: &[S], active: &mut [bool]) -> Vec<S> {
    let size = rates.len();
    let slack = largest(rates.iter().map(|r| r.abs())) * S::from_f64(64.0 * S::EPSILON);
    let mut solution = solve_active(matrix, rates, active);
    for _ in 0..size * size + 16 {
        let wrong = (0..size).find(|&k| {
            if active[k] {
                solution[k] * matrix[k][k] < -slack
            } else {
                rate(matrix, rates, &solution, k) < -slack
            }
        });
        let Some(k) = wrong else { break };
        active[k] = !active[k];
        solution = solve_active(matrix, rates, active);
    }
    solution.into_iter().map(|value| if value < S::ZERO { S::ZERO } else { value }).collect()
}

fn rate<S: Scalar>(matrix: &[Vec<S>], rates: &[S], solution: &[S], k: usize) -> S {
    let mut sum = rates[k];
    for (&a, &x) in matrix[k].iter().zip(solution) {
        sum += a * x;
    }
    sum
}

/// The solution of `A λ = −u` over the active entries, the others zero, by Cholesky's factors.
fn solve_active<S: Scalar>(matrix: &[Vec<S>], rates: &[S], active: &[bool]) -> Vec<S> {
    let chosen: Vec<usize> = (0..rates.len()).filter(|&k| active[k]).collect();
    let factor = cholesky(matrix, &chosen);
    let mut values: Vec<S> = chosen.iter().map(|&k| -rates[k]).collect();
    for i in 0..values.len() {
        for j in 0..i {
            let step = factor[i][j] * values[j];
            values[i] -= step;
        }
        values[i] = values[i] / factor[i][i];
    }
    for i in (0..values.len()).rev() {
        for j in i + 1..values.len() {
            let step = factor[j][i] * values[j];
            values[i] -= step;
        }
        values[i] = values[i] / factor[i][i];
    }
    let mut solution = vec![S::ZERO; rates.len()];
    for (&k, &value) in chosen.iter().zip(&values) {
        solution[k] = value;
    }
    solution
}

fn cholesky<S: Scalar>(matrix: &[Vec<S>], chosen: &[usize]) -> Vec<Vec<S>> {
    let size = chosen.len();
    let mut factor = vec![vec![S::ZERO; size]; size];
    for i in 0..size {
        for j in 0..=i {
            let mut sum = matrix[chosen[i]][chosen[j]];
            for (&left, &right) in factor[i][..j].iter().zip(&factor[j][..j]) {
                sum -= left * right;
            }
            factor[i][j] = if i == j { sum.sqrt() } else { sum / factor[j][j] };
        }
    }
    factor
}

fn largest<S: Scalar>(values: impl Iterator<Item = S>) -> S {
    values.fold(S::ZERO, |most, value| if value > most { value } else { most })
}

#[cfg(test)]
mod tests {
    use super::solve_complementarity;

    #[test]
    fn two_coupled_contacts_stop_together() {
        let impulses = solve_complementarity(&[vec![2.0, 1.0], vec![1.0, 2.0]], &[-3.0, -3.0]);
        assert!((impulses[0] - 1.0).abs() < 1e-15 && (impulses[1] - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_contact_that_the_other_opens_gets_nothing() {
        let impulses = solve_complementarity(&[vec![2.0, 1.9], vec![1.9, 2.0]], &[-4.0, -1.0]);
        assert!((impulses[0] - 2.0).abs() < 1e-15);
        assert_eq!(impulses[1], 0.0);
    }

    #[test]
    fn a_contact_given_twice_is_shared_equally() {
        let impulses = solve_complementarity(&[vec![1.0, 1.0], vec![1.0, 1.0]], &[-2.0, -2.0]);
        // Round-off over the proximal weight: what the null space of A lets through.
        let tolerance = 4.0 * f64::EPSILON / super::PROXIMAL_WEIGHT;
        assert!((impulses[0] - 1.0).abs() < tolerance && (impulses[1] - 1.0).abs() < tolerance);
        assert!((impulses[0] + impulses[1] - 2.0).abs() < 4.0 * f64::EPSILON);
    }
}
