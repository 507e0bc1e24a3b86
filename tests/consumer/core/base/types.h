#error "A file of the user's own, which no header of geolloyd may find."
