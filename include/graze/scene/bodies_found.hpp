// What a search through cells has found.
#pragma once

#include <graze/scene/body.hpp>
#include <graze/scene/image_code.hpp>
#include <graze/scene/records.hpp>

namespace graze::inline v0_1::detail {

// Adds all bodies, except one, to a list and, unless that is null, their images to another list.
struct bodies_found {
    records<body>& bodies;
    records<image_code>* images;
    body except = no_body;

    void operator()(body b, image_code image) {
        if (b != except) {
            bodies.push_back(b);
            if (images != nullptr) {
                images->push_back(image);
            }
        }
    }
};

} // namespace graze::inline v0_1::detail
