/* Run @name@ over its duration, and print its states and impacts. */
#include <stdio.h>
#include <stdlib.h>

#include "@n@.h"

int main(void)
{
    double states[@N@_STATES + 1], duration = @duration@;
    int i, k, code;
    void *memory = malloc(@n@_size()); /* once: nothing is allocated later */
    @n@ *s = @n@_create(memory, @n@_size());
    if (!s) return 1;
    code = @n@_start(s, duration);
    for (k = 0; k <= 10 && code >= 0; ++k) {
        code = @n@_advance(s, duration * k / 10, 0);
        @n@_states(s, states);
        printf("t = %.6g s:", @n@_time(s));
        for (i = 0; i < @N@_STATES; ++i)
            printf(" %s = %.9g %s", @n@_name(@N@_STATE, i), states[i], @n@_unit(@N@_STATE, i));
        printf("\n");
    }
    for (i = 0; i < @N@_PAIRS; ++i) {
        @n@_contact latest;
        @n@_latest(s, i, &latest);
        printf("%s: %d impacts", @n@_name(@N@_PAIR, i), latest.count);
        if (latest.count) printf(", the last at %.6g s with %.4g m/s", latest.begin, latest.approach_speed);
        printf("\n");
    }
    printf("%s\n", @n@_text(code));
    free(memory);
    return code < 0;
}
