// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/c/barrier.h>

#include <annulus/error.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>

namespace annulus::inline v1::c {

namespace {

annulus_status status_of(Error_code code) noexcept {
    switch (code) {
        case Error_code::not_finite: return ANNULUS_NOT_FINITE;
        case Error_code::out_of_domain: return ANNULUS_OUT_OF_DOMAIN;
        case Error_code::duplicate_point: return ANNULUS_DUPLICATE_POINT;
        case Error_code::wrong_size: return ANNULUS_WRONG_SIZE;
        case Error_code::unknown_vertex: return ANNULUS_UNKNOWN_VERTEX;
        case Error_code::environment: return ANNULUS_ENVIRONMENT;
        case Error_code::usage: return ANNULUS_USAGE;
        case Error_code::too_large: return ANNULUS_TOO_LARGE;
        case Error_code::bad_input: return ANNULUS_NO_TRIANGULATION;  // here the only input that can be bad is cells
        case Error_code::too_few: break;
    }
    return ANNULUS_INTERNAL;
}

}  // namespace

int Last_error::note(annulus_status status, const char* why, std::span<const std::int64_t> vertices) noexcept {
    const std::lock_guard lock(writing_);
    const std::size_t length = std::min(std::strlen(why), text_.size() - 1);
    std::memcpy(text_.data(), why, length);
    text_[length] = '\0';
    vertex_count_ = std::min(vertices.size(), first_.size());
    for (std::size_t k = 0; k < vertex_count_; ++k) first_[k] = static_cast<std::int32_t>(vertices[k]);
    more_.clear();
    if (vertices.size() > vertex_count_) try {
            more_.assign(vertices.begin(), vertices.end());
            vertex_count_ = more_.size();
        } catch (const std::bad_alloc&) {
            more_.clear();
        }
    return status;
}

std::size_t Last_error::copy(char* buffer, std::size_t capacity) const noexcept {
    const std::lock_guard lock(writing_);
    const std::size_t length = std::strlen(text_.data());
    if (buffer != nullptr && capacity > 0) {
        const std::size_t kept = std::min(length, capacity - 1);
        std::memcpy(buffer, text_.data(), kept);
        buffer[kept] = '\0';
    }
    return length;
}

std::size_t Last_error::copy_vertices(std::size_t capacity, std::int32_t* vertices) const noexcept {
    const std::lock_guard lock(writing_);
    const std::int32_t* const all = more_.empty() ? first_.data() : more_.data();
    if (vertices != nullptr) std::copy_n(all, std::min(capacity, vertex_count_), vertices);
    return vertex_count_;
}

Last_error& error_of_thread() noexcept {
    static thread_local Last_error error;
    return error;
}

int note_exception(Last_error& error) noexcept {
    try {
        throw;
    } catch (const Refused& e) {
        return error.note(e.status(), e.what());
    } catch (const Error& e) {
        return error.note(status_of(e.code()), e.what(), e.vertices());
    } catch (const std::bad_alloc&) {
        return error.note(ANNULUS_NO_MEMORY, "memory ran out");
    } catch (const std::length_error&) {
        return error.note(ANNULUS_NO_MEMORY, "an array would be larger than memory can be");
    } catch (const std::exception& e) {
        return error.note(ANNULUS_INTERNAL, e.what());
    } catch (...) {
        return error.note(ANNULUS_INTERNAL, "something that is no exception of the standard library was thrown");
    }
}

void require_count(std::size_t count, const char* of) {
    if (count > PTRDIFF_MAX / (4 * sizeof(double)))
        throw Refused(ANNULUS_WRONG_SIZE, std::to_string(count) + ' ' + of + " are more than memory can hold");
}

}  // namespace annulus::inline v1::c
