//! Memory: large pages for what is large, and lines of it that are fetched before they are needed.
//!
//! A million balls lie in so many small pages that the processor spends more time on finding these than on the balls. Both
//! here are advice: no result depends on it.

#![allow(unsafe_code)]

/// So many bytes are worth large pages.
#[cfg(target_os = "linux")]
const LARGE: usize = 1 << 21;

/// Room for so many items, in large pages where they are many and the system has such.
pub fn room_for<T>(count: usize) -> Vec<T> {
    let room: Vec<T> = Vec::with_capacity(count);
    #[cfg(target_os = "linux")]
    {
        let bytes = room.capacity() * size_of::<T>();
        let page = 4096;
        let from = (room.as_ptr() as usize).next_multiple_of(page);
        if bytes >= LARGE {
            let length = bytes - page;
            // SAFETY: these whole pages lie in the room that was just made, and the advice changes nothing of what is in them.
            // Where there are no large pages it fails, and nothing else happens.
            unsafe { libc::madvise(from as *mut libc::c_void, length / page * page, libc::MADV_HUGEPAGE) };
        }
    }
    room
}

/// Fetches a line of memory that will be needed soon; nothing where there is no such item.
#[inline(always)]
pub fn fetch<T>(items: &[T], place: usize) {
    #[cfg(target_arch = "x86_64")]
    {
        let item = items.as_ptr().wrapping_add(place);
        // SAFETY: a prefetch of any address is harmless: it reads nothing, and fails nowhere.
        unsafe { core::arch::x86_64::_mm_prefetch::<{ core::arch::x86_64::_MM_HINT_T0 }>(item.cast()) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (items, place);
}
