// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

//! A wall with two plates in front of it, of which one slides to the right; build.rs, lib.rs and the loop are those of
//! docs/embedding/rust.md.

use slam_masks::{label, Camera, Tracker};

const W: usize = 320;
const H: usize = 240;
const LEFT: usize = 40; // of the plate that stands

/// Smooth noise between 28 and 228, the same at every call.
fn texture(seed: u32, x: usize, y: usize) -> u8 {
    let value = |x: usize, y: usize| {
        let mut h = (x as u32).wrapping_mul(374761393) ^ (y as u32).wrapping_mul(668265263) ^ seed.wrapping_mul(2246822519);
        h = (h ^ (h >> 13)).wrapping_mul(1274126177);
        ((h ^ (h >> 16)) & 255) as f64
    };
    let mut sum = 0.0;
    for dy in 0..5 {
        for dx in 0..5 {
            sum += value(x + dx, y + dy);
        }
    }
    (128.0 + 2.0 * (sum / 25.0 - 127.5)).clamp(28.0, 228.0) as u8
}

fn next_frame(frame: usize) -> (Vec<u8>, Vec<f32>, Vec<u8>) {
    let right = 170 + 4 * frame;
    let (mut grey, mut metres, mut ids) = (vec![0; W * H], vec![4.0; W * H], vec![0; W * H]);
    for y in 0..H {
        for x in 0..W {
            let i = y * W + x;
            grey[i] = texture(1, x, y);
            for (id, left) in [(1u8, LEFT), (2, right)] {
                if (80..170).contains(&y) && (left..left + 80).contains(&x) {
                    (grey[i], metres[i], ids[i]) = (texture(10 + id as u32, x - left, y), 2.0, id);
                }
            }
        }
    }
    (grey, metres, ids)
}

fn run() -> Result<(), String> {
    // snippet: rust_use
    // end of snippet

    // The library's text comes through, and what is wrong changes nothing.
    let (grey, metres, _) = next_frame(10);
    let refused = tracker.track(0.5, &grey, &metres, None).unwrap_err();
    assert!(refused.contains("frame.timestamp"), "{refused}");
    let labels = tracker.track(1.0, &grey, &metres, None)?;
    let at = |x: usize| labels[125 * W + x];
    assert_eq!((at(LEFT + 40), at(170 + 40 + 40), at(LEFT - 20)), (label::STATIC, label::MOVING, label::BACKGROUND));
    tracker.reset();
    tracker.track(0.0, &grey, &metres, None)?;
    assert!(tracker.track(0.1, &grey[1..], &metres, None).is_err());
    assert!(Tracker::new(Camera { fx: 0.0, ..camera }).err().unwrap().contains("fx"));
    Ok(())
}

fn main() {
    if let Err(text) = run() {
        eprintln!("{text}");
        std::process::exit(1);
    }
}
