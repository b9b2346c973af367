// of T: what adds less has no colour. Twin of UNSEEN in src/field/boundTerm.ts.
const UNSEEN = 1e-3;
