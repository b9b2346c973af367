/** The empty page: three steps above, drawings to open below; the pen draws through everything but the cards. */
import { css } from 'lit';

export const startLayout = css`
  .start { position: absolute; inset: 5rem var(--gap) var(--gap); display: flex; flex-direction: column; gap: 0.75rem; pointer-events: none; --fig: clamp(4rem, 20cqh, 13rem); --thumb: clamp(3.5rem, 8.5cqh, 7rem); }
  .start button { pointer-events: auto; }
  .hint { flex: 1; min-height: 0; display: flex; flex-direction: column; justify-content: center; width: min(56rem, calc(100% - 24rem)); margin: 0 auto; padding-bottom: 3cqh; text-align: center; }
  .hint { color: var(--over); }
  .hint h2 { font: 600 2rem/2.5rem var(--font); letter-spacing: -0.015em; }
  .hint > p { color: var(--over-2); margin-top: 0.375rem; font-size: 1.0625rem; line-height: 1.5rem; }
  .hint ol { display: grid; grid-template-columns: 1fr 1fr 1fr; margin: clamp(0.75rem, 3.5cqh, 2.25rem) 0 0; padding: 0; list-style: none; gap: 1rem; }
  .hint svg { height: var(--fig); width: 100%; display: block; }
  .hint li b { display: block; font: 600 1rem/1.375rem var(--font); margin-top: 0.75rem; }
  .hint li span { display: block; max-width: 13.5rem; margin: 0.125rem auto 0; font-size: 0.875rem; line-height: 1.25rem; color: var(--over-2); }

  .gallery header { display: flex; align-items: center; justify-content: space-between; gap: 1rem; padding: 0 0.25rem 0.5rem; }
  .gallery h2 { color: var(--over); font: 600 1.0625rem/1.375rem var(--font); }
  .cards { display: grid; grid-template-columns: repeat(var(--all), minmax(0, 1fr)); gap: 0.75rem; list-style: none; padding: 0; }
  .cards button { width: 100%; padding: 0.5rem 0.25rem; text-align: center; transition: background var(--press) var(--out); }
  .cards button:hover { background: var(--sunken); }
  .cards button:active { transform: scale(0.98); }
  .cards img { width: 100%; height: var(--thumb, 6rem); object-fit: contain; display: block; }
  .cards b { display: block; font: 600 0.9375rem/1.25rem var(--font); }
  .cards small { display: block; font-size: 0.75rem; line-height: 1rem; color: var(--ink-2); }

  /* with drawings below there is nothing to turn yet, and one line says what happened */
  .start.filled { bottom: 2.75rem; }
  .start.filled ~ .view { display: none; }
  .start.filled ~ .status { flex-direction: row; gap: 0.75rem; bottom: 0.75rem; max-width: none; }

  @container (max-width: 1099px) {
    .start { --thumb: clamp(3.5rem, 10cqh, 7.5rem); }
    /* beside the named rail */
    .hint { width: auto; margin: 0 0 0 12.5rem; }
  }
  /* the rail reaches down to the cards */
  @container (min-width: 700px) and (max-height: 880px) {
    .gallery { margin-left: 12.5rem; }
  }
  @container (min-width: 700px) and (max-height: 560px) {
    .gallery { margin-left: 5rem; }
  }
  @container (max-width: 1099px) and (max-height: 840px) {
    .start { --thumb: clamp(3rem, 8.5cqh, 4.5rem); --fig: clamp(4rem, 15cqh, 10rem); }
    .start .cards button { padding: 0.25rem 0.25rem 0.375rem; }
    .hint { padding-bottom: 0; }
    .hint li b { margin-top: 0.375rem; }
  }
  /* narrow cards: the longest name fits */
  @container (max-width: 1499px) {
    .start .cards { gap: 0.5rem; }
    .start .cards b { font-size: 0.8125rem; line-height: 1.125rem; }
  }
  /* one row to be moved sideways */
  @container (max-width: 1239px) or (max-height: 780px) {
    .start .cards { grid-template-columns: none; grid-auto-flow: column; grid-auto-columns: minmax(7.5rem, 1fr); overflow-x: auto; scrollbar-width: none; scroll-snap-type: x proximity; padding: 0.25rem; margin: -0.25rem; }
    .start .cards li { scroll-snap-align: start; }
  }
  @container (max-width: 699px) {
    .start { inset: 3.75rem 0.5rem calc(7.75rem + env(safe-area-inset-bottom, 0px)); --fig: clamp(4rem, 15cqh, 8rem); --thumb: clamp(3.5rem, 11cqh, 6rem); gap: 0.5rem; }
    .start.filled { bottom: calc(8.5rem + env(safe-area-inset-bottom, 0px)); }
    .start.filled ~ .status { flex-direction: column; gap: 0; left: 0.75rem; right: 0.75rem; bottom: calc(5rem + env(safe-area-inset-bottom, 0px)); }
    .hint { width: auto; margin: 0; padding-bottom: 0; }
    .hint h2 { font-size: 1.5rem; line-height: 1.875rem; }
    .hint > p { font-size: 0.9375rem; line-height: 1.3125rem; margin-top: 0.125rem; }
    .hint ol { gap: 0.5rem; }
    .hint li b { font-size: 0.875rem; line-height: 1.125rem; margin-top: 0.375rem; }
    .hint li span { font-size: 0.75rem; line-height: 1rem; }
    .gallery header { padding-bottom: 0.25rem; }
    .gallery .more { display: none; }
  }
  @container (max-height: 560px) and (min-width: 700px) {
    .hint { margin-left: 5rem; width: auto; justify-content: flex-start; }
    .hint ol { display: none; }
    .start.filled ~ .status { left: 6rem; }
  }
  /* room for one of the two */
  @container (max-height: 400px) {
    .start.filled .hint { display: none; }
    .start.filled { justify-content: flex-end; }
  }
`;
